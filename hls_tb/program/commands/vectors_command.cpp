// SPDX-License-Identifier: Apache-2.0
#include "program/commands/vectors_command.hpp"

#include <CLI/CLI.hpp>
#include <charconv>
#include <iostream>
#include <sstream>

#include "cosim/stage_files.hpp"
#include "cosim/vector_files.hpp"
#include "engines/clocked/core_modules.hpp"
#include "engines/clocked/run_core.hpp"
#include "program/commands/checks.hpp"
#include "program/commands/named_matching.hpp"
#include "program/commands/pair_options.hpp"
#include "program/errors.hpp"
#include "program/io/images.hpp"
#include "program/io/output_folder.hpp"

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

template <class Writer, class... Content>
std::string text_of(Writer write, const Content&... content) {
   std::ostringstream out;
   write(out, content...);
   return out.str();
}

struct VectorsArguments {
   std::string config, left, right, out;
   std::string rows;  ///< "A:B"; empty for all
   Fit fit = Fit::none;
   StimulusOptions options;
   int broken = 0;  ///< events of a broken stream instead of frames
};

Stimulus stream(const VectorsArguments& arguments, const std::string& config, const CoreShape& shape) {
   const Image& image = shape.image;
   StimulusOptions options = arguments.options;
   if (!arguments.rows.empty()) options.rows = parse_rows(arguments.rows);
   const auto stream_of = [&](auto loaded) {
      const auto pair = fit_pair(std::move(loaded), image.width_px, image.height_px, arguments.fit);
      if (arguments.broken == 0) return make_stimulus(config, shape, pair, options);
      return make_broken_stimulus(config, shape, pair, arguments.broken, options.stall_percent, options.seed);
   };
   if (shape.pixel_bits > 8) return stream_of(load_deep_pair(arguments.left, arguments.right, shape.pixel_bits));
   return stream_of(load_pair(arguments.left, arguments.right));
}

void write(const VectorsArguments& arguments, std::size_t clocks, std::size_t outputs, std::string stimulus,
           std::string expected) {
   OutputFolder out(arguments.out);
   out.add("stimulus.txt", std::move(stimulus));
   out.add("expected.txt", std::move(expected));
   std::cout << clocks << " clocks, " << outputs << " outputs\n";
   out.commit();
}

void vectors_of_stage(const VectorsArguments& arguments, const Stage& stage) {
   const std::vector<StageClock> clocks =
       make_stage_stimulus(stage, stream(arguments, stage.name, stage.shape), arguments.options.seed);
   const std::vector<StageOutput> outputs = run_stage(stage, clocks);
   write(arguments, clocks.size(), outputs.size(), text_of(write_stage_stimulus, stage, clocks),
         text_of(write_stage_expected, stage, outputs));
}

void vectors(const VectorsArguments& arguments) {
   if (const Stage* const stage = find_stage(arguments.config)) return vectors_of_stage(arguments, *stage);
   const CoreModule& core = core_module(require_configuration(arguments.config).name);
   const Stimulus stimulus = stream(arguments, core.name, core.shape);
   const Expected expected{core.name, core.shape.image.pixels_per_clock, core.shape.disparity_bits,
                           core.shape.schedule.latency_clocks, run_core(core, stimulus)};
   write(arguments, stimulus.clocks.size(), expected.outputs.size(), text_of(write_stimulus, stimulus),
         text_of(write_expected, expected));
}

}  // namespace

void add_vectors(CLI::App& app) {
   static VectorsArguments arguments;
   StimulusOptions& options = arguments.options;
   CLI::App* command = app.add_subcommand("vectors", "make test vectors for the hardware: stimulus.txt, expected.txt");
   command->add_option("--config", arguments.config, "configuration")->required();
   command->add_option("--out", arguments.out, "folder for the results")->required();
   CLI::Option* const rows = command->add_option("--rows", arguments.rows, "send only image rows A:B, B excluded");
   CLI::Option* const frames =
       command->add_option("--frames", options.frames, "frames back to back, odd ones upside down")
           ->check(CLI::Range(1, 1000))
           ->capture_default_str();
   command
       ->add_option("--broken", arguments.broken,
                    "instead of frames, so many faults of a stream: broken frames, records without start, resets")
       ->check(CLI::Range(1, 1000))
       ->excludes(frames)
       ->excludes(rows);
   command->add_option("--stall-percent", options.stall_percent, "chance of a bubble before a pixel pair")
       ->check(CLI::Range(0, 95))
       ->capture_default_str();
   command->add_option("--seed", options.seed, "of the bubbles and flush rows")
       ->capture_default_str()
       ->check(check_seed);
   add_pair_options(*command, arguments.left, arguments.right, arguments.fit);
   command->callback([] { vectors(arguments); });
}

}  // namespace stereo::app
