// SPDX-License-Identifier: Apache-2.0
#include "app/commands.hpp"

#include <charconv>
#include <iostream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "app/errors.hpp"
#include "app/images.hpp"
#include "app/named_matching.hpp"
#include "app/options_json.hpp"
#include "app/output_folder.hpp"
#include "app/pair_options.hpp"
#include "models/scene.hpp"
#include "vectors/matching_parameters.hpp"
#include "vectors/vector_files.hpp"

namespace stereo::app {
namespace {

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

template <class Content, class Writer>
std::string text_of(const Content& content, Writer write) {
   std::ostringstream out;
   write(out, content);
   return out.str();
}

nlohmann::json as_json(const Configuration& entry) {
   const StereoConfig& config = entry.config;
   nlohmann::json json = options_json(matching_parameters(config));
   json.update({{"width_px", config.width_px},
                {"height_px", config.height_px},
                {"pixels_per_clock", config.pixels_per_clock},
                {"aggregation", config.aggregation == Aggregation::recursive ? "recursive" : "direct"},
                {"slice_disparities", config.slice_disparities},
                {"cost_clocks", config.cost_clocks},
                {"winner_group", config.winner_group},
                {"disparity_bits", config.disparity_bits()},
                {"output_width_px", config.output_width_px()},
                {"output_height_px", config.output_height_px()},
                {"latency_clocks", entry.latency_clocks},
                {"groups_to_first_output", config.groups_to_first_output()},
                {"flush_groups", config.flush_groups()},
                {"gap_groups", config.gap_groups()}});
   return json;
}

struct SceneArguments {
   std::string config, out;  ///< an empty config leaves the size to `options`
   SceneOptions options;
};

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
   out.add("disparity_left.png", encode_png(made.left_disparity));
   out.add("visible_left.png", encode_png(made.left_visible));
   out.commit();
}

struct VectorsArguments {
   std::string config, left, right, out;
   std::string rows;  ///< "A:B"; empty for all
   Fit fit = Fit::none;
   StimulusOptions options;
};

void vectors(const VectorsArguments& arguments) {
   const Configuration& configuration = require_configuration(arguments.config);
   const StereoConfig& config = configuration.config;
   StimulusOptions options = arguments.options;
   if (!arguments.rows.empty()) options.rows = parse_rows(arguments.rows);
   const ImagePair pair =
       fit_pair(load_pair(arguments.left, arguments.right), config.width_px, config.height_px, arguments.fit);
   const Stimulus stimulus = make_stimulus(configuration.name, config, configuration.latency_clocks, pair, options);
   const Expected expected{configuration.name, config.pixels_per_clock, config.disparity_bits(),
                           configuration.latency_clocks, configuration.run(stimulus.clocks)};
   OutputFolder out(arguments.out);
   out.add("stimulus.txt", text_of(stimulus, write_stimulus));
   out.add("expected.txt", text_of(expected, write_expected));
   std::cout << stimulus.clocks.size() << " clocks, " << expected.outputs.size() << " outputs\n";
   out.commit();
}

struct TraceArguments {
   std::string config, out;
   int clocks = 1000;
};

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
      std::cout << entry.name << ": " << size_text(entry.config.width_px, entry.config.height_px) << ", "
                << entry.config.disparities << " disparities, window "
                << size_text(entry.config.window_px, entry.config.window_px) << ", output "
                << size_text(entry.config.output_width_px(), entry.config.output_height_px()) << ", latency "
                << entry.latency_clocks << " clocks\n";
}

}  // namespace

void add_scene(CLI::App& app) {
   static SceneArguments arguments;
   SceneOptions& options = arguments.options;
   CLI::App* command = app.add_subcommand("scene", "make a stereo pair with ground truth: left.png, right.png, ...");
   command->add_option("--out", arguments.out, "folder for the results")->required();
   command->add_option("--seed", options.seed, "another number, another scene")
       ->required()
       ->check(CLI::NonNegativeNumber);
   CLI::Option* config = command->add_option("--config", arguments.config, "take the size from this configuration");
   command->add_option("--width", options.width, "image width")->capture_default_str()->excludes(config);
   command->add_option("--height", options.height, "image height")->capture_default_str()->excludes(config);
   command->add_option("--disparities", options.disparities, "disparity range")
       ->capture_default_str()
       ->excludes(config);
   command->add_option("--noise", options.noise, "sensor noise in grey levels")->capture_default_str();
   command->callback([] { scene(arguments); });
}

void add_vectors(CLI::App& app) {
   static VectorsArguments arguments;
   StimulusOptions& options = arguments.options;
   CLI::App* command = app.add_subcommand("vectors", "make test vectors for the hardware: stimulus.txt, expected.txt");
   command->add_option("--config", arguments.config, "configuration")->required();
   command->add_option("--out", arguments.out, "folder for the results")->required();
   command->add_option("--rows", arguments.rows, "send only image rows A:B, B excluded");
   command->add_option("--frames", options.frames, "frames back to back, odd ones upside down")
       ->check(CLI::Range(1, 1000))
       ->capture_default_str();
   command->add_option("--stall-percent", options.stall_percent, "chance of a bubble before a pixel pair")
       ->check(CLI::Range(0, 95))
       ->capture_default_str();
   command->add_option("--seed", options.seed, "of the bubbles and flush rows")
       ->capture_default_str()
       ->check(CLI::NonNegativeNumber);
   add_pair_options(*command, arguments.left, arguments.right, arguments.fit);
   command->callback([] { vectors(arguments); });
}

void add_trace(CLI::App& app) {
   static TraceArguments arguments;
   CLI::App* command = app.add_subcommand("trace", "trace all registers of the clocked core: trace.txt");
   command->add_option("--config", arguments.config, "configuration")->required();
   command->add_option("--out", arguments.out, "folder for the result")->required();
   command->add_option("--clocks", arguments.clocks, "length")->check(CLI::Range(10, 1000000))->capture_default_str();
   command->callback([] { trace(arguments); });
}

void add_configurations(CLI::App& app) {
   static bool as_json = false;
   CLI::App* command = app.add_subcommand("configurations", "list the hardware configurations");
   command->add_flag("--json", as_json, "as JSON, for scripts");
   command->callback([] { list_configurations(as_json); });
}

}  // namespace stereo::app
