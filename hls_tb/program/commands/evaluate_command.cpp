// SPDX-License-Identifier: Apache-2.0
#include "program/commands/evaluate_command.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <optional>

#include "program/commands/checks.hpp"
#include "program/commands/named_matching.hpp"
#include "program/commands/options_json.hpp"
#include "program/commands/pair_options.hpp"
#include "program/commands/postprocessing_options.hpp"
#include "program/commands/threads_option.hpp"
#include "program/commands/timed.hpp"
#include "program/errors.hpp"
#include "program/evaluation/camera_difference.hpp"
#include "program/evaluation/evaluation.hpp"
#include "program/evaluation/opencv_matchers.hpp"
#include "program/evaluation/truth.hpp"
#include "program/io/disparity_files.hpp"
#include "program/io/images.hpp"
#include "program/io/match_files.hpp"
#include "program/io/output_folder.hpp"

namespace stereo::app {
namespace {

constexpr double kLargestChange = 65535;  ///< of a grey value

struct Arguments {
   std::string left, right, truth_left, truth_right, json;
   std::string visible_left, visible_right;
   std::optional<double> truth_scale, disparity_scale, unknown;
   int border_px = kIgnoredBorder;
   std::vector<std::string> configs, settings, opencv, disparities, references;
   int opencv_disparities = 0, opencv_block = 0;  ///< 0: as stored
   CameraDifference cameras;
   int threads = 1;
   Engine engine = Engine::fast;
   Postprocessing postprocessing;
};

/// The images and, of each that has one, truth and masks.
struct GroundTruth {
   int bits = 8;     ///< of a grey value
   ImagePair shown;  ///< of 8 bits, as loaded: which pixels count does not depend on the cameras
   AnyPair seen;     ///< what is matched
   std::optional<DisparityImage> left, right;
   std::vector<NamedMask> left_masks, right_masks;

   const std::optional<DisparityImage>& of(Reference side) const { return side == Reference::left ? left : right; }
   const std::vector<NamedMask>& masks(Reference side) const {
      return side == Reference::left ? left_masks : right_masks;
   }
};

void require_size(const DisparityImage& image, const GrayImage& wanted, const std::string& what) {
   if (!image.same_size(wanted))
      throw InputError(what + ": is " + size_text(image) + " but the images are " + size_text(wanted));
}

/// `visible`: an image that is 0 where pixels do not count; then 0 is a true disparity, too.
std::optional<DisparityImage> load_truth(const std::string& side, const std::string& path, const std::string& visible,
                                         const Arguments& arguments, const GrayImage& image) {
   const std::string option = "--truth-" + side;
   if (path.empty() && !visible.empty()) throw InputError("--visible-" + side + " " + visible + ": needs " + option);
   if (path.empty()) return std::nullopt;
   const DisparityCoding coding{arguments.truth_scale, arguments.unknown, !visible.empty()};
   auto [truth, scale, remark] = load_disparities(option, path, coding);
   if (!remark.empty()) std::cout << remark << '\n';
   require_size(truth, image, option + " " + path);
   if (!visible.empty()) {
      const GrayImage mask = load_gray(visible);
      if (!mask.same_size(image))
         throw InputError("--visible-" + side + " " + visible + ": is " + size_text(mask) + " but the images are " +
                          size_text(image));
      for (std::size_t i = 0; i < truth.px.size(); ++i)
         if (mask.pixels[i] == 0) truth.px[i] = kNoDisparity;
   }
   if (std::none_of(truth.px.begin(), truth.px.end(), has_disparity))
      throw InputError(option + " " + path + ": none of its pixels has a true disparity");
   return truth;
}

/// Of the grey values that every named configuration takes.
int least_pixel_bits(const Arguments& arguments) {
   if (arguments.configs.empty()) return 8;
   int least = 16;
   for (const std::string& name : arguments.configs)
      least = std::min(least, named_algorithm(name, arguments.settings)->pixel_bits());
   return least;
}

GroundTruth load(const Arguments& arguments) {
   if (arguments.truth_left.empty() && arguments.truth_right.empty())
      throw InputError("evaluate: give the true disparities with --truth-left, --truth-right or both");
   GroundTruth truth;
   const int bits = least_pixel_bits(arguments);
   const AnyPair pair = load_any_pair(arguments.left, arguments.right, bits);
   if (std::holds_alternative<DeepPair>(pair)) truth.bits = bits;
   truth.shown = shown_pair(pair, truth.bits);
   truth.seen =
       std::visit([&](const auto& images) { return AnyPair(seen_by(images, arguments.cameras, truth.bits)); }, pair);
   truth.left = load_truth("left", arguments.truth_left, arguments.visible_left, arguments, truth.shown.left);
   truth.right = load_truth("right", arguments.truth_right, arguments.visible_right, arguments, truth.shown.right);
   const auto address = [](const std::optional<DisparityImage>& image) { return image ? &*image : nullptr; };
   if (truth.left)
      truth.left_masks =
          evaluation_masks(truth.shown.left, *truth.left, address(truth.right), Reference::left, arguments.border_px);
   if (truth.right)
      truth.right_masks =
          evaluation_masks(truth.shown.right, *truth.right, address(truth.left), Reference::right, arguments.border_px);
   return truth;
}

/// The pixels of a map that count.
GrayImage counted_pixels(const std::vector<NamedMask>& masks, const MapGeometry& geometry, int height) {
   GrayImage counted(std::max(geometry.width, 0), height);  // too narrow images are refused where they are matched
   for (int y = 0; y < height; ++y)
      for (int x = 0; x < counted.width; ++x)
         counted.at(x, y) = masks.empty() ? 1 : masks.front().mask.at(geometry.first_column + x, y);
   return counted;
}

/// range: the disparities that the method looks for; nothing where they are not known.
void score(EvaluatedMethod& method, const DisparityImage& found, std::optional<DisparityRange> range,
           const GroundTruth& truth) {
   const std::optional<DisparityImage>& wanted = truth.of(method.reference);
   if (!wanted) return;
   method.masks = measure_masks(found, method.reference, range, *wanted, truth.masks(method.reference));
   std::string remark = range ? range_remark(method.name, *wanted, *range) : "";
   if (remark.empty() && !method.masks.empty()) {
      const Measures& all = method.masks.front().measures;
      remark = bad_remark(method.name, double(all.bad_by_more_than_1_px()), double(all.valid));
   }
   if (!remark.empty()) method.remarks.push_back(remark);
}

EvaluatedMethod evaluate_core(const std::string& name, const Arguments& arguments, const GroundTruth& truth) {
   const auto algorithm = named_algorithm(name, arguments.settings);
   EvaluatedMethod method{name, "core", Reference::left, options_json(algorithm->options())};
   method.engine = word_of(arguments.engine);
   method.postprocessing = postprocessing_json(arguments.postprocessing);
   const MapGeometry geometry = algorithm->map_geometry(truth.shown.left.width);
   const GrayImage counted = counted_pixels(truth.masks(geometry.reference), geometry, truth.shown.left.height);
   Postprocessing postprocessing = arguments.postprocessing;
   postprocessing.counted = &counted;
   const auto match_once = [&](const auto& pair) {
      return match_named(name, pair, *algorithm, arguments.threads, arguments.engine);
   };
   const auto match = [&](const auto& pair) {
      return match_and_process(match_once, pair, geometry, postprocessing).map;
   };
   const DisparityMap map = timed(method.milliseconds, [&] { return std::visit(match, truth.seen); });
   method.reference = geometry.reference;
   score(method, at_image_size(map, geometry, truth.shown.left.width), range_of(*algorithm), truth);
   return method;
}

EvaluatedMethod evaluate_opencv(const std::string& word, const Arguments& arguments, const GroundTruth& truth) {
   OpenCvMatcher matcher = OpenCvMatcher::stored(opencv_kinds().at(word));
   if (arguments.opencv_disparities != 0) matcher.disparities = arguments.opencv_disparities;
   if (arguments.opencv_block != 0) matcher.block_px = arguments.opencv_block;
   check_opencv_matcher(matcher, truth.shown.left.width, truth.shown.left.height);
   EvaluatedMethod method{matcher.name(), "opencv", Reference::left, parameters_json(matcher)};
   if (truth.bits > 8)
      method.remarks.push_back(method.name + " gets the upper 8 of the images' " + std::to_string(truth.bits) +
                               " bits");
   const ImagePair seen = shown_pair(truth.seen, truth.bits);
   score(method, timed(method.milliseconds, [&] { return match_opencv(seen, matcher, arguments.threads); }),
         DisparityRange{0, matcher.disparities}, truth);
   return method;
}

/// `reference`: a word of the command line; empty where match.json says it.
EvaluatedMethod evaluate_file(const std::string& path, const std::string& reference, const Arguments& arguments,
                              const GroundTruth& truth) {
   const std::string name = "--disparity " + path;
   EvaluatedMethod method{path, "file", Reference::left};
   const auto own = load_own_map("--disparity", path, arguments.disparity_scale);
   LoadedDisparities found =
       own ? LoadedDisparities{own->image, own->scale, ""}
           : load_disparities("--disparity", path, {.scale = arguments.disparity_scale, .unknown = arguments.unknown});
   if (!own && reference.empty())
      throw InputError(name + ": has no match.json of this program beside it; say its --reference, left or right");
   method.reference = reference.empty() ? own->reference : reference_words().at(reference);
   if (own && method.reference != own->reference)
      throw InputError("--reference " + reference + ": match.json beside " + path + " says " + word_of(own->reference));
   require_size(found.image, truth.shown.left, name);
   method.parameters = {{"scale", found.scale}};
   method.milliseconds = kNoDisparity;
   score(method, found.image, std::nullopt, truth);
   if (!found.remark.empty()) method.remarks.push_back(found.remark);
   return method;
}

/// Where --opencv-disparities says nothing, --set disparities does, as the next multiple of 16.
void follow_set_disparities(Arguments& arguments) {
   if (arguments.opencv.empty() || arguments.opencv_disparities != 0) return;
   std::string set;
   for_each_setting(arguments.settings, [&](const std::string& name, const std::string& value) {
      if (name == "disparities") set = value;
   });
   if (set.empty()) return;
   constexpr int kSteps = 16, kMost = 1 << 20;  // far more than OpenCV takes, which is checked later
   arguments.opencv_disparities = (std::clamp(std::stoi(set), 1, kMost) + kSteps - 1) / kSteps * kSteps;
   std::cout << "OpenCV's matchers search " << arguments.opencv_disparities << " disparities (--set disparities=" << set
             << ")\n";
}

void write_json(const Arguments& arguments, const nlohmann::json& json) {
   std::vector<std::string> inputs = arguments.disparities;
   inputs.insert(inputs.end(), {arguments.left, arguments.right, arguments.truth_left, arguments.truth_right,
                                arguments.visible_left, arguments.visible_right});
   const std::filesystem::path file(arguments.json);
   OutputFolder out(file.parent_path().empty() ? "." : file.parent_path().string(), inputs, "--json");
   out.add_json(file.filename().string(), json);
   out.commit();
}

void evaluate(Arguments arguments) {
   if (!arguments.references.empty() && arguments.disparities.size() != arguments.references.size())
      throw InputError("--disparity: each of the " + std::to_string(arguments.disparities.size()) +
                       " files needs its own --reference left or right, in the same order, or none does");
   if (arguments.configs.empty() && arguments.opencv.empty() && arguments.disparities.empty())
      throw InputError("evaluate: name what to evaluate with --config, --opencv or --disparity");
   if (arguments.configs.empty() && !arguments.settings.empty())
      throw InputError("--set: changes the options of configurations; name one with --config");
   if (arguments.configs.empty() && (arguments.engine == Engine::clocked || arguments.postprocessing.rejects()))
      throw InputError(
          "--engine clocked, --speckle-window, --least-confidence, --surest and --measured-only are for "
          "configurations; name one with --config");
   require_settable(arguments.engine, arguments.settings);
   for (const std::string& name : arguments.configs) named_algorithm(name, arguments.settings);  // throws
   follow_set_disparities(arguments);
   const GroundTruth truth = load(arguments);
   Evaluation evaluation{arguments.left,
                         arguments.right,
                         truth.shown.left.width,
                         truth.shown.left.height,
                         arguments.border_px,
                         arguments.threads,
                         {}};
   for (const std::string& name : arguments.configs)
      evaluation.methods.push_back(evaluate_core(name, arguments, truth));
   for (const std::string& word : arguments.opencv)
      evaluation.methods.push_back(evaluate_opencv(word, arguments, truth));
   for (std::size_t i = 0; i < arguments.disparities.size(); ++i)
      evaluation.methods.push_back(evaluate_file(
          arguments.disparities[i], arguments.references.empty() ? "" : arguments.references[i], arguments, truth));
   std::cout << evaluation_text(evaluation);
   if (!arguments.json.empty()) write_json(arguments, evaluation_json(evaluation));
}

void add_methods(CLI::App& command, Arguments& arguments) {
   command.add_option("--config", arguments.configs, "configuration, run on the whole images; may be repeated")
       ->allow_extra_args(false);
   command
       .add_option("--set", arguments.settings,
                   "NAME=VALUE: an option of all named configurations, such as window_px=9")
       ->allow_extra_args(false);
   add_choice(command, "--engine", arguments.engine, engine_words(),
              "fast (default): the software models, any size; clocked: the hardware's C++, images of its size");
   add_postprocessing_options(command, arguments.postprocessing, "the configurations' maps");
   command
       .add_option("--opencv", arguments.opencv,
                   "OpenCV's StereoBM or StereoSGBM: bm, sgbm or another mode of sgbm; may be repeated")
       ->allow_extra_args(false)
       ->check(CLI::IsMember(&opencv_kinds()));
   command
       .add_option(
           "--opencv-disparities", arguments.opencv_disparities,
           "disparities of OpenCV's matchers; default: --set disparities, rounded up to a multiple of 16, else 48")
       ->check(CLI::PositiveNumber);
   command
       .add_option("--opencv-block", arguments.opencv_block,
                   "block of OpenCV's matchers; default 15 for bm, 3 for sgbm")
       ->check(CLI::PositiveNumber);
   command
       .add_option("--disparity", arguments.disparities,
                   "a disparity map of the images' size, in a format of --truth-left; may be repeated")
       ->allow_extra_args(false);
   command
       .add_option("--reference", arguments.references,
                   "left or right, one for each --disparity; needed unless match.json stands beside each")
       ->allow_extra_args(false)
       ->check(CLI::IsMember(&reference_words()));
   command.add_option("--disparity-scale", arguments.disparity_scale, "as --truth-scale, for --disparity")
       ->check(check_positive_number);
}

}  // namespace

void add_evaluate(CLI::App& app) {
   static Arguments arguments;
   CLI::App* command = app.add_subcommand("evaluate", "measure disparity maps against ground truth");
   command->add_option("--left", arguments.left, "left image of the rectified pair")->required();
   command->add_option("--right", arguments.right, "right image")->required();
   command->add_option(
       "--truth-left", arguments.truth_left,
       "the left image's true disparities: PFM, float TIFF or .npy; 8 bits or 16 bits as KITTI's (0 unknown)");
   command->add_option("--truth-right", arguments.truth_right, "the right image's");
   command
       ->add_option("--truth-scale", arguments.truth_scale,
                    "units of the truth in a pixel; default: 256 for 16-bit files (KITTI), else 1")
       ->check(check_positive_number);
   command->add_option("--visible-left", arguments.visible_left,
                       "mask of the left image: its pixels of 0 do not count; 0 in the truth is then a disparity");
   command->add_option("--visible-right", arguments.visible_right, "the right image's");
   command->add_option(
       "--unknown", arguments.unknown,
       "a value in files of disparities that marks unknown pixels, such as -1; values that are not finite always do");
   command->add_option("--border", arguments.border_px, "pixels at each side of the images that do not count")
       ->check(CLI::Range(0, 10000))
       ->capture_default_str();
   command
       ->add_option("--gain", arguments.cameras.gain,
                    "multiply the grey values of the right image by this before matching")
       ->check(check_positive_number)
       ->check(CLI::Range(0.0, kLargestChange))
       ->capture_default_str();
   command
       ->add_option("--offset", arguments.cameras.offset,
                    "add this to the grey values of the right image before matching")
       ->check(check_number)
       ->check(CLI::Range(-kLargestChange, kLargestChange))
       ->capture_default_str();
   command
       ->add_option("--noise", arguments.cameras.noise,
                    "add noise of this standard deviation to both images before matching")
       ->check(CLI::Range(0, 255))
       ->capture_default_str();
   command->add_option("--noise-seed", arguments.cameras.seed, "another number, other noise")
       ->check(CLI::NonNegativeNumber)
       ->capture_default_str();
   add_methods(*command, arguments);
   add_threads_option(*command, arguments.threads, "the fast model and of OpenCV");
   command->add_option("--json", arguments.json, "file for the results, as JSON");
   command->callback([] { evaluate(arguments); });
}

}  // namespace stereo::app
