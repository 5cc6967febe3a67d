// SPDX-License-Identifier: Apache-2.0
// stereo_hls._core: the models, cores and measures for numpy arrays. What users see, with its checks of types and
// shapes, is stereo_hls/__init__.py; arrays come here contiguous and of the right type.
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "definition/pixel_range.hpp"
#include "engines/clocked/core_modules.hpp"
#include "engines/clocked/match_clocked.hpp"
#include "engines/clocked/register_trace.hpp"
#include "engines/configurations.hpp"
#include "program/commands/configurations_json.hpp"
#include "program/commands/options_json.hpp"
#include "program/evaluation/evaluation.hpp"
#include "scene/scene.hpp"

namespace py = pybind11;

namespace {

using namespace stereo;

template <class Value>
using Array = py::array_t<Value, py::array::c_style>;
using Settings = std::vector<std::pair<std::string, std::string>>;

template <class Value>
Array<Value> array_of(const std::vector<Value>& values, int height, int width) {
   Array<Value> array({height, width});
   std::copy(values.begin(), values.end(), array.mutable_data());
   return array;
}
template <class Pixel>
Array<Pixel> array_of(const RasterImage<Pixel>& image) {
   return array_of(image.pixels, image.height, image.width);
}

template <class Pixel>
RasterImage<Pixel> image_of(const Array<Pixel>& array) {
   RasterImage<Pixel> image(int(array.shape(1)), int(array.shape(0)));
   std::copy_n(array.data(), image.pixels.size(), image.pixels.begin());
   return image;
}

DeepImage deep_image(const char* name, const Array<uint16_t>& array, int bits) {
   DeepImage image = image_of(array);
   if (const std::string problem = beyond_range(image, bits); !problem.empty())
      throw std::invalid_argument(std::string(name) + ": " + problem);
   return image;
}
/// What is not finite has no disparity.
app::DisparityImage disparities_of(const Array<float>& array) {
   app::DisparityImage image(int(array.shape(1)), int(array.shape(0)));
   std::transform(array.data(), array.data() + image.px.size(), image.px.begin(),
                  [](float px) { return std::isfinite(px) ? px : app::kNoDisparity; });
   return image;
}

Reference reference_of(const std::string& word) { return app::reference_words().at(word); }

const Configuration& configuration_of(const std::string& name) {
   const Configuration* const found = find_configuration(name);
   if (found == nullptr) throw std::invalid_argument(name + ": " + no_such_configuration());
   return *found;
}

std::shared_ptr<const Algorithm> algorithm_of(const Configuration& configuration, const Settings& settings) {
   std::shared_ptr<const Algorithm> algorithm = configuration.algorithm;
   for (const auto& [name, value] : settings) {
      try {
         algorithm = algorithm->with(name, value);
      } catch (const std::invalid_argument& problem) {
         throw std::invalid_argument(name + "=" + value + ": " + problem.what());
      }
   }
   return algorithm;
}

ImagePair pair_of(const Array<uint8_t>& left, const Array<uint8_t>& right, const Algorithm&) {
   return {image_of(left), image_of(right)};
}
DeepPair pair_of(const Array<uint16_t>& left, const Array<uint16_t>& right, const Algorithm& algorithm) {
   const int bits = algorithm.pixel_bits();
   if (bits == 8) throw py::type_error("left, right: must be arrays of uint8 where pixel_bits is 8");
   return {deep_image("left", left, bits), deep_image("right", right, bits)};
}

/// Pixel: uint8_t or, where pixel_bits is more than 8, uint16_t.
template <class Pixel>
py::dict match(const Array<Pixel>& left, const Array<Pixel>& right, const std::string& name, const Settings& settings,
               bool clocked, int threads) {
   const Configuration& configuration = configuration_of(name);
   const auto algorithm = algorithm_of(configuration, settings);
   const auto pair = pair_of(left, right, *algorithm);
   DisparityMap map;
   {
      const py::gil_scoped_release others_may_run;
      map = clocked ? match_clocked(core_module(name), pair) : algorithm->match_fast(pair.left, pair.right, threads);
   }
   const MapGeometry geometry = algorithm->map_geometry(pair.left.width);
   const app::DisparityRange range = app::range_of(*algorithm);
   const app::DisparityImage px = app::at_image_size(map, geometry, pair.left.width);
   py::dict result;
   result["disparity"] = array_of(px.px, px.height, px.width);
   result["steps"] = array_of(map.disparity, map.height, map.width);
   result["valid"] = array_of(map.valid, map.height, map.width);
   result["confidence"] =
       map.confidence.empty() ? py::object(py::none()) : array_of(map.confidence, map.height, map.width);
   result["filled"] = map.filled.empty() ? py::object(py::none()) : array_of(map.filled, map.height, map.width);
   result["steps_per_px"] = map.steps_per_pixel();
   result["first_column"] = geometry.first_column;
   result["reference"] = app::word_of(geometry.reference);
   result["search"] = std::pair(range.first, range.count);
   result["options"] = app::options_json(algorithm->options()).dump();
   return result;
}

Array<uint8_t> shown(const char* name, const Array<uint16_t>& image, int bits) {
   return array_of(upper_8_bits(deep_image(name, image, bits), bits));
}

std::string evaluate(const Array<float>& found, const Array<float>& truth,
                     const std::optional<Array<float>>& other_truth, const std::optional<Array<uint8_t>>& image,
                     const std::string& reference, std::optional<std::pair<int, int>> search, int border_px) {
   const app::DisparityImage map = disparities_of(found), wanted = disparities_of(truth);
   const GrayImage shown = image ? image_of(*image) : GrayImage(wanted.width, wanted.height);
   std::optional<app::DisparityImage> other;
   if (other_truth) other = disparities_of(*other_truth);
   const py::gil_scoped_release others_may_run;
   std::vector<app::NamedMask> masks =
       app::evaluation_masks(shown, wanted, other ? &*other : nullptr, reference_of(reference), border_px);
   if (!image) std::erase_if(masks, [](const app::NamedMask& mask) { return mask.name == app::kMaskNames.back(); });
   std::optional<app::DisparityRange> range;
   if (search) range = app::DisparityRange{search->first, search->second};
   return app::measures_json(app::measure_masks(map, reference_of(reference), range, wanted, masks)).dump();
}

py::dict scene(int width, int height, int disparities, uint64_t seed, int noise, int pixel_bits) {
   Scene made;
   DeepPair deep;
   {
      const py::gil_scoped_release others_may_run;
      made = make_scene({.width = width, .height = height, .disparities = disparities, .seed = seed, .noise = noise});
      if (pixel_bits > 8) deep = deepened(made.images, pixel_bits, seed);
   }
   py::dict result;
   const auto add_pair = [&](const auto& pair) {
      result["left"] = array_of(pair.left);
      result["right"] = array_of(pair.right);
   };
   if (pixel_bits > 8) add_pair(deep);
   else add_pair(made.images);
   result["truth_left"] = array_of(made.left_disparity);
   result["truth_right"] = array_of(made.disparity);
   return result;
}

/// All values of a trace, [name][clock].
struct Columns final : TraceSink {
   std::vector<std::string> all;
   std::vector<std::vector<uint64_t>> bits;
   std::vector<bool> negative;  ///< in any clock

   void names(const std::vector<std::string>& names) override {
      all = names;
      bits.resize(names.size());
      negative.resize(names.size());
   }
   void clock(std::span<const Value> values) override {
      for (std::size_t i = 0; i < values.size(); ++i) {
         bits[i].push_back(values[i].bits);
         if (values[i].negative) negative[i] = true;
      }
   }
};

py::dict trace(const std::string& name, int clocks) {
   const CoreModule& core = core_module(configuration_of(name).name);
   Columns columns;
   {
      const py::gil_scoped_release others_may_run;
      trace_core(core, make_trace_stimulus(core.name, core.shape, clocks), columns);
   }
   py::dict result;
   for (std::size_t i = 0; i < columns.all.size(); ++i) {
      const py::array_t<uint64_t> values(py::ssize_t(columns.bits[i].size()), columns.bits[i].data());
      const char* const type = columns.negative[i] ? "int64" : "uint64";
      result[columns.all[i].c_str()] = values.attr("view")(type);
   }
   return result;
}

}  // namespace

PYBIND11_MODULE(_core, module) {
   py::register_exception<NoCoreModule>(module, "CoreNotBuilt", PyExc_RuntimeError);
   module.attr("version") = STEREO_HLS_VERSION;
   module.def("set_core_folder", &set_core_folder);
   module.def("configurations", [] { return app::configurations_json().dump(); });
   module.def("families", [] { return app::families_json().dump(); });
   module.def("match", &match<uint8_t>);
   module.def("match_deep", &match<uint16_t>);
   module.def("shown", &shown);
   module.def("evaluate", &evaluate);
   module.def("scene", &scene);
   module.def("trace", &trace);
}
