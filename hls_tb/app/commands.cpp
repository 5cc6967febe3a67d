// SPDX-License-Identifier: Apache-2.0
#include "app/commands.hpp"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cstdlib>
#include <iomanip>
#include <iostream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "app/errors.hpp"
#include "app/output_folder.hpp"
#include "app/overview.hpp"
#include "models/fast_model.hpp"
#include "vectors/vector_files.hpp"

namespace stereo::app {
namespace {

constexpr int kBadPixelTolerance = 1;  // disparity steps, as stereo benchmarks count

/// The pair at the size that is matched.
ImagePair load_pair_to_match(const MatchArguments& arguments, const Configuration& configuration) {
   const StereoConfig& config = configuration.config;
   ImagePair pair = load_pair(arguments.left, arguments.right);
   if (arguments.engine == Engine::clocked || arguments.fit != Fit::none)
      pair = fit_pair(std::move(pair), config.width_px, config.height_px, arguments.fit);
   else if (pair.left.width != config.width_px || pair.left.height != config.height_px)
      std::cout << "the images are " << pair.left.width << 'x' << pair.left.height << ", not the " << config.width_px
                << 'x' << config.height_px << " of " << configuration.name
                << ": its disparity range and window are applied to the whole images\n";
   if (pair.left.width <= config.disparities)
      throw InputError(arguments.left + ": is " + std::to_string(pair.left.width) +
                       " pixels wide but must be wider than the " + std::to_string(config.disparities) +
                       " disparities of " + configuration.name + "; give larger images or another --config");
   return pair;
}

struct TruthScore {
   int compared = 0;  ///< visible pixels that have a disparity
   int bad = 0;       ///< of those, off by more than the tolerance
};

TruthScore score(const MatchArguments& arguments, const ImagePair& pair, const GrayImage& map) {
   const GrayImage truth = load_gray(arguments.truth), visible = load_gray(arguments.visible);
   const auto require_size = [&](const std::string& option, const GrayImage& image) {
      if (!image.same_size(pair.right))
         throw InputError(option + ": the image is " + std::to_string(image.width) + "x" +
                          std::to_string(image.height) + " but the matched right image is " +
                          std::to_string(pair.right.width) + "x" + std::to_string(pair.right.height));
   };
   require_size("--truth " + arguments.truth, truth);
   require_size("--visible " + arguments.visible, visible);
   TruthScore result;
   for (int y = 0; y < map.height; ++y)
      for (int x = 0; x < map.width; ++x) {
         if (visible.at(x, y) == 0) continue;
         ++result.compared;
         result.bad += std::abs(int(map.at(x, y)) - int(truth.at(x, y))) > kBadPixelTolerance;
      }
   return result;
}

GrayImage match_clocked(const ImagePair& pair, const Configuration& configuration) {
   const Stimulus stimulus =
       make_stimulus(configuration.name, configuration.config, configuration.latency_clocks, pair);
   const std::vector<GrayImage> frames = collect_frames(configuration.run(stimulus.clocks), configuration.config);
   if (frames.size() != 1)
      throw std::runtime_error("the clocked core gave " + std::to_string(frames.size()) + " frames");
   return frames.front();
}

RowRange parse_rows(const std::string& text) {
   RowRange rows;
   const char* const end = text.data() + text.size();
   const auto first = std::from_chars(text.data(), end, rows.first);
   if (first.ec == std::errc() && first.ptr != end && *first.ptr == ':') {
      const auto last = std::from_chars(first.ptr + 1, end, rows.end);
      if (last.ec == std::errc() && last.ptr == end) return rows;
   }
   throw InputError("--rows " + text + ": must be A:B, the first row and the one after the last, such as 10:20");
}

const char* fit_word(Fit fit) { return fit == Fit::crop ? "crop" : fit == Fit::resize ? "resize" : "none"; }

template <class Content, class Writer>
std::string text_of(const Content& content, Writer write) {
   std::ostringstream out;
   write(out, content);
   return out.str();
}

/// Of the delay of the right image and of the line memories of both.
int memory_bits(const StereoConfig& config) {
   return config.disparities * 8 * config.pixels_per_clock + 2 * config.width_px * 8 * config.stored_rows();
}

nlohmann::json as_json(const Configuration& entry) {
   const StereoConfig& config = entry.config;
   return {{"width_px", config.width_px},
           {"height_px", config.height_px},
           {"disparities", config.disparities},
           {"window_px", config.window_px},
           {"pixels_per_clock", config.pixels_per_clock},
           {"slice_disparities", config.slice_disparities},
           {"cost_clocks", config.cost_clocks},
           {"winner_group", config.winner_group},
           {"disparity_bits", config.disparity_bits()},
           {"output_width_px", config.output_width_px()},
           {"output_height_px", config.output_height_px()},
           {"latency_clocks", entry.latency_clocks},
           {"flush_groups", config.flush_groups()},
           {"gap_groups", config.gap_groups()},
           {"memory_bits", memory_bits(config)}};
}

}  // namespace

const Configuration& require_configuration(const std::string& name) {
   const Configuration* const found = find_configuration(name);
   if (found != nullptr) return *found;
   std::string known;
   for (const Configuration& entry : configuration_table()) known += (known.empty() ? "" : ", ") + entry.name;
   throw InputError("--config " + name + ": there is no such configuration; known are: " + known);
}

void match(const MatchArguments& arguments) {
   const Configuration& configuration = require_configuration(arguments.config);
   const StereoConfig& config = configuration.config;
   const ImagePair pair = load_pair_to_match(arguments, configuration);
   const bool fast = arguments.engine == Engine::fast;
   const auto start = std::chrono::steady_clock::now();
   const GrayImage map = fast ? match_fast(pair.left, pair.right, {config.disparities, config.window_px})
                              : match_clocked(pair, configuration);
   const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - start;

   nlohmann::json facts{
       {"format", "stereo-hls match 1"}, {"config", configuration.name},  {"engine", fast ? "fast" : "clocked"},
       {"left", arguments.left},         {"right", arguments.right},      {"fit", fit_word(arguments.fit)},
       {"width_px", pair.left.width},    {"height_px", pair.left.height}, {"disparities", config.disparities},
       {"window_px", config.window_px},  {"output_width_px", map.width},  {"output_height_px", map.height},
       {"milliseconds", time.count()}};
   std::ostringstream text;
   text << pair.left.width << 'x' << pair.left.height << ", " << config.disparities << " disparities, window "
        << config.window_px << 'x' << config.window_px << " -> " << map.width << 'x' << map.height << ", "
        << (fast ? "fast model" : "clocked core") << ", " << std::fixed << std::setprecision(2) << time.count()
        << " ms\n";
   if (!arguments.truth.empty()) {
      const TruthScore truth = score(arguments, pair, map);
      facts["truth"] = {{"disparity", arguments.truth},
                        {"visible", arguments.visible},
                        {"tolerance_px", kBadPixelTolerance},
                        {"compared_px", truth.compared},
                        {"bad_px", truth.bad}};
      text << "bad pixels (> " << kBadPixelTolerance << " px): " << truth.bad << " of " << truth.compared
           << " visible ones (" << 100.0 * truth.bad / std::max(truth.compared, 1) << " %)\n";
   }

   OutputFolder out(arguments.out);
   out.add("disparity.png", encode_png(map));
   out.add("disparity_color.png", encode_color_png(map, config.disparities));
   out.add("overview.png", encode_overview_png(pair, map, config.disparities));
   // A path may hold bytes that are no UTF-8.
   out.add("match.json", facts.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
   std::cout << text.str();
   out.commit();
}

void scene(const SceneArguments& arguments) {
   SceneOptions options = arguments.options;
   if (!arguments.config.empty()) {
      const StereoConfig& config = require_configuration(arguments.config).config;
      options.width = config.width_px;
      options.height = config.height_px;
      options.disparities = config.disparities;
   }
   const Scene made = make_scene(options);
   OutputFolder out(arguments.out);
   out.add("left.png", encode_png(made.images.left));
   out.add("right.png", encode_png(made.images.right));
   out.add("disparity_right.png", encode_png(made.disparity));
   out.add("visible_right.png", encode_png(made.visible));
   out.commit();
}

void vectors(const VectorsArguments& arguments) {
   const Configuration& configuration = require_configuration(arguments.config);
   const StereoConfig& config = configuration.config;
   StimulusOptions options = arguments.options;
   if (!arguments.rows.empty()) options.rows = parse_rows(arguments.rows);
   const ImagePair pair =
       fit_pair(load_pair(arguments.left, arguments.right), config.width_px, config.height_px, arguments.fit);
   const Stimulus stimulus = make_stimulus(configuration.name, config, configuration.latency_clocks, pair, options);
   const Expected expected{configuration.name, config.pixels_per_clock, config.disparity_bits(), configuration.latency_clocks,
                           configuration.run(stimulus.clocks)};
   OutputFolder out(arguments.out);
   out.add("stimulus.txt", text_of(stimulus, write_stimulus));
   out.add("expected.txt", text_of(expected, write_expected));
   std::cout << stimulus.clocks.size() << " clocks, " << expected.outputs.size() << " outputs\n";
   out.commit();
}

void trace(const TraceArguments& arguments) {
   constexpr int kStallPercent = 20;
   constexpr uint64_t kSeed = 1;
   const Configuration& configuration = require_configuration(arguments.config);
   const int pixels = configuration.config.pixels_per_clock;
   StimulusWriter writer(pixels, kStallPercent, kSeed);
   writer.bubbles(4);
   writer.record({.left = {0x5a}, .right = {0xa5}, .start_of_frame = true, .valid = true});
   writer.random_records(arguments.clocks);
   writer.clocks.resize(std::size_t(arguments.clocks));
   std::ostringstream text;
   configuration.trace({configuration.name, pixels, writer.clocks}, text);
   OutputFolder out(arguments.out);
   out.add("trace.txt", text.str());
   out.commit();
}

void list_configurations(bool as_json_text) {
   if (as_json_text) {
      nlohmann::json all;
      for (const Configuration& entry : configuration_table()) all[entry.name] = as_json(entry);
      std::cout << all.dump(2) << '\n';
      return;
   }
   for (const Configuration& entry : configuration_table())
      std::cout << entry.name << ": " << entry.config.width_px << 'x' << entry.config.height_px << ", "
                << entry.config.disparities << " disparities, window " << entry.config.window_px << 'x'
                << entry.config.window_px << ", output " << entry.config.output_width_px() << 'x'
                << entry.config.output_height_px() << ", latency " << entry.latency_clocks << " clocks\n";
}

}  // namespace stereo::app
