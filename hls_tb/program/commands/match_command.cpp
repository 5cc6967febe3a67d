// SPDX-License-Identifier: Apache-2.0
#include "program/commands/match_command.hpp"

#include <algorithm>
#include <iomanip>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>

#include "program/commands/checks.hpp"
#include "program/commands/named_matching.hpp"
#include "program/commands/options_json.hpp"
#include "program/commands/pair_options.hpp"
#include "program/commands/postprocessing_options.hpp"
#include "program/commands/threads_option.hpp"
#include "program/commands/timed.hpp"
#include "program/depth/pair_warnings.hpp"
#include "program/errors.hpp"
#include "program/evaluation/evaluation.hpp"
#include "program/evaluation/truth.hpp"
#include "program/io/disparity_files.hpp"
#include "program/io/images.hpp"
#include "program/io/match_files.hpp"
#include "program/io/output_folder.hpp"
#include "program/io/overview.hpp"

namespace stereo::app {
namespace {

struct Arguments {
   std::string config, left, right, out;
   std::vector<std::string> settings;
   std::string truth, visible;  ///< the reference image's true disparities, and what counts of them
   std::optional<double> truth_scale, unknown;
   std::vector<std::string> formats;  ///< of kFormats
   Postprocessing postprocessing;
   Engine engine = Engine::fast;
   Fit fit = Fit::none;
   int threads = 1;
};

struct Format {
   const char* file;
   std::string (*encode)(const DisparityImage&);
};
/// {word of --write: what is written}
const std::map<std::string, Format> kFormats{{"pfm", {kPfmName, encode_pfm}},
                                             {"kitti", {kKittiName, encode_kitti_png}}};

bool wants(const Arguments& arguments, const std::string& format) {
   return std::find(arguments.formats.begin(), arguments.formats.end(), format) != arguments.formats.end();
}

/// The pair at the size that is matched.
template <class Pair>
Pair sized_pair(Pair pair, const Arguments& arguments, const Configuration& configuration) {
   const Image& wanted = configuration.shape.image;
   if (arguments.engine == Engine::clocked || arguments.fit != Fit::none)
      pair = fit_pair(std::move(pair), wanted.width_px, wanted.height_px, arguments.fit);
   else if (pair.left.width != wanted.width_px || pair.left.height != wanted.height_px)
      std::cout << "the images are " << size_text(pair.left) << ", not the "
                << size_text(wanted.width_px, wanted.height_px) << " of " << configuration.name
                << ": its options are applied to the whole images\n";
   return pair;
}

std::string line_of(const std::string& remark) { return remark.empty() ? "" : remark + "\n"; }

struct LoadedScore {
   TruthScore counts;
   double scale;  ///< of the truth
};

LoadedScore load_and_score(const Arguments& arguments, const DisparityMap& map, const MapGeometry& geometry,
                           const GrayImage& reference, DisparityRange range) {
   // Which pixels count is said in one place: by --visible, else by the pixels of the truth that are not 0.
   const bool has_visible = !arguments.visible.empty();
   const auto [truth, scale, remark] =
       load_disparities("--truth", arguments.truth, {arguments.truth_scale, arguments.unknown, has_visible});
   const GrayImage visible =
       has_visible ? load_gray(arguments.visible) : GrayImage(reference.width, reference.height, 255);
   const auto require_size = [&](const std::string& option, const auto& image) {
      if (!image.same_size(reference))
         throw InputError(option + ": the image is " + size_text(image) + " but the matched " +
                          word_of(geometry.reference) + " image is " + size_text(reference));
   };
   require_size("--truth " + arguments.truth, truth);
   require_size("--visible " + arguments.visible, visible);
   std::cout << line_of(remark) << line_of(range_remark(arguments.config, truth, range));
   return {score_against_truth(map, geometry, truth, visible), scale};
}

const char* fit_word(Fit fit) { return fit == Fit::crop ? "crop" : fit == Fit::resize ? "resize" : "none"; }

/// Share of the map's pixels that are valid.
double density(const DisparityMap& map) {
   return double(std::count(map.valid.begin(), map.valid.end(), 1)) / double(map.valid.size());
}

/// What match.json holds, and what is printed.
struct Facts {
   nlohmann::json json;
   std::ostringstream text;
};

void add_matching(Facts& facts, const Arguments& arguments, const DisparityMap& map, const Algorithm& algorithm,
                  const ImagePair& pair, double milliseconds) {
   const bool fast = arguments.engine == Engine::fast;
   const MapGeometry geometry = algorithm.map_geometry(pair.left.width);
   facts.json = options_json(algorithm.options());
   facts.json.update({{"format", kFactsFormat},
                      {"config", arguments.config},
                      {"engine", word_of(arguments.engine)},
                      {"left", arguments.left},
                      {"right", arguments.right},
                      {"fit", fit_word(arguments.fit)},
                      {"width_px", pair.left.width},
                      {"height_px", pair.left.height},
                      {"output_width_px", map.width},
                      {"output_height_px", map.height},
                      {"output_first_column", geometry.first_column},
                      {"reference", word_of(geometry.reference)},
                      {"disparity_steps_per_px", map.steps_per_pixel()},
                      {"density", density(map)},
                      {"threads", fast ? arguments.threads : 1},
                      {"postprocessing", postprocessing_json(arguments.postprocessing)},
                      {"milliseconds", milliseconds}});
   facts.text << size_text(pair.left) << ", " << algorithm.description() << " -> " << size_text(map) << ", "
              << (fast ? "fast model, threads: " + std::to_string(arguments.threads) : "clocked core") << ", "
              << std::fixed << std::setprecision(2) << milliseconds << " ms\n";
   if (geometry.has_check || arguments.postprocessing.rejects())
      facts.text << "valid pixels: " << 100 * density(map) << " %\n";
   if (!map.filled.empty()) {
      const double filled = double(std::count(map.filled.begin(), map.filled.end(), 1)) / double(map.filled.size());
      facts.json["filled"] = filled;
      facts.text << "filled pixels: " << 100 * filled << " %\n";
   }
}

void add_truth(Facts& facts, const Arguments& arguments, const LoadedScore& score) {
   const TruthScore& truth = score.counts;
   facts.json["truth"] = {{"disparity", arguments.truth},       {"scale", score.scale},          {"visible", nullptr},
                          {"tolerance_px", kBadPixelTolerance}, {"compared_px", truth.compared}, {"bad_px", truth.bad},
                          {"invalid_px", truth.invalid}};
   const bool has_visible = !arguments.visible.empty();
   if (has_visible) facts.json["truth"]["visible"] = arguments.visible;
   const char* const which = has_visible ? " visible ones" : " with a true disparity";
   facts.text << "bad pixels (> " << kBadPixelTolerance << " px): " << truth.bad << " of " << truth.compared << which
              << " (" << 100.0 * truth.bad / std::max(truth.compared, 1) << " %)";
   if (truth.invalid > 0) facts.text << "; " << truth.invalid << which << " are invalid and do not count";
   facts.text << '\n' << line_of(bad_remark(arguments.config, truth.bad, truth.compared));
}

template <class Pair>
void match_pair(const Arguments& arguments, const Algorithm& algorithm, const Pair& matched) {
   const ImagePair& pair = shown_pair(matched, algorithm.pixel_bits());
   double milliseconds = 0;
   const MapGeometry geometry = algorithm.map_geometry(pair.left.width);
   const std::string warning = pair_warning(pair, geometry);
   std::cout << warning;
   const auto match_once = [&](const Pair& images) {
      return match_named(arguments.config, images, algorithm, arguments.threads, arguments.engine);
   };
   const auto [map, confidence] =
       timed(milliseconds, [&] { return match_and_process(match_once, matched, geometry, arguments.postprocessing); });

   if (warning.empty()) std::cout << last_disparity_warning(map, geometry);
   Facts facts;
   add_matching(facts, arguments, map, algorithm, pair, milliseconds);
   const GrayImage& reference = geometry.reference == Reference::left ? pair.left : pair.right;
   if (!arguments.truth.empty())
      add_truth(facts, arguments, load_and_score(arguments, map, geometry, reference, range_of(algorithm)));

   OutputFolder out(arguments.out, {arguments.left, arguments.right, arguments.truth, arguments.visible});
   out.add(kMapName, encode_png(map));
   out.add("disparity_color.png", encode_color_png(map, geometry.disparities));
   if (geometry.has_check || arguments.postprocessing.rejects()) out.add(kValidName, encode_valid_png(map));
   if (!map.filled.empty()) out.add(kFilledName, encode_filled_png(map));
   if (confidence && (arguments.postprocessing.wants_confidence || !map.confidence.empty()))
      out.add("confidence.png", encode_png(*confidence));
   for (const auto& [word, format] : kFormats)
      if (wants(arguments, word)) out.add(format.file, format.encode(at_image_size(map, geometry, pair.left.width)));
   if (const int lost = beyond_kitti(at_image_size(map, geometry, pair.left.width));
       wants(arguments, "kitti") && lost > 0)
      facts.text << kKittiName << " leaves " << lost << " disparities out, which its 16 bits cannot hold\n";
   out.add("overview.png", encode_overview_png(pair, map, geometry));
   out.add_facts(kFactsName, facts.json);
   std::cout << facts.text.str();
   out.commit();
}

void match(const Arguments& arguments) {
   const Configuration& configuration = require_configuration(arguments.config);
   require_settable(arguments.engine, arguments.settings);
   const auto algorithm = named_algorithm(arguments.config, arguments.settings);
   const auto match_loaded = [&](auto pair) {
      match_pair(arguments, *algorithm, sized_pair(std::move(pair), arguments, configuration));
   };
   if (const int bits = algorithm->pixel_bits(); bits > 8)
      match_loaded(load_deep_pair(arguments.left, arguments.right, bits));
   else match_loaded(load_pair(arguments.left, arguments.right));
}

}  // namespace

void add_match(CLI::App& app) {
   static Arguments arguments;
   CLI::App* command = app.add_subcommand("match", "make a disparity map: disparity.png, overview.png, match.json ...");
   command->add_option("--config", arguments.config, "configuration")->required();
   command->add_option("--out", arguments.out, "folder for the results")->required();
   add_choice(*command, "--engine", arguments.engine, engine_words(),
              "fast (default): the software model, any size; clocked: the hardware's C++");
   command
       ->add_option("--set", arguments.settings,
                    "NAME=VALUE: override an option of the configuration, such as window_px=9")
       ->allow_extra_args(false);
   add_threads_option(*command, arguments.threads);
   add_pair_options(*command, arguments.left, arguments.right, arguments.fit);
   add_postprocessing_options(*command, arguments.postprocessing);
   command->add_flag("--confidence", arguments.postprocessing.wants_confidence,
                     "also write confidence.png: 255 for the surest pixels, 0 for pixels without confidence; always "
                     "written with the option confidence");
   command
       ->add_option("--write", arguments.formats,
                    "also write the map at the size of the image: pfm (disparity.pfm, infinity where invalid) or kitti "
                    "(disparity_kitti.png, 16 bits, 0 where invalid); may be repeated")
       ->allow_extra_args(false)
       ->check(CLI::IsMember(&kFormats));
   CLI::Option* truth = command->add_option(
       "--truth", arguments.truth,
       "ground truth of the reference image, in a format of evaluate --truth-left: count bad pixels");
   command
       ->add_option("--truth-scale", arguments.truth_scale,
                    "units of the truth in a pixel; default: 256 for 16-bit files (KITTI), else 1")
       ->check(check_positive_number)
       ->needs(truth);
   command->add_option("--unknown", arguments.unknown, "a value of the truth that marks unknown pixels, such as -1")
       ->needs(truth);
   command
       ->add_option("--visible", arguments.visible,
                    "mask: its pixels of 0 do not count; 0 in the truth is then a disparity")
       ->needs(truth);
   command->callback([] { match(arguments); });
}

}  // namespace stereo::app
