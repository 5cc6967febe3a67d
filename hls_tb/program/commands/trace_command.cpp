// SPDX-License-Identifier: Apache-2.0
#include "program/commands/trace_command.hpp"

#include <CLI/CLI.hpp>
#include <sstream>

#include "engines/clocked/core_modules.hpp"
#include "engines/clocked/register_trace.hpp"
#include "program/commands/named_matching.hpp"
#include "program/io/output_folder.hpp"

namespace stereo::app {
namespace {

struct TraceArguments {
   std::string config, out;
   int clocks = 1000;
};

void trace(const TraceArguments& arguments) {
   constexpr int kStallPercent = 20;
   constexpr uint64_t kSeed = 1;
   const CoreModule& core = core_module(require_configuration(arguments.config).name);
   const int pixels = core.shape.image.pixels_per_clock;
   StimulusWriter writer(pixels, kStallPercent, kSeed);
   writer.bubbles(4);
   const auto records_of_a_frame = [&writer](int count) {
      writer.record({.left = {0x5a}, .right = {0xa5}, .start_of_frame = true, .valid = true});
      writer.random_records(count - 1);
   };
   // A frame that is broken off, then frames as close as they may be: what only happens between frames shows as well,
   // where the frames are short enough.
   const Image& image = core.shape.image;
   const std::size_t clocks = std::size_t(arguments.clocks);
   records_of_a_frame(image.width_px / 2);
   while (writer.clocks.size() < clocks) {
      records_of_a_frame(image.width_px * image.row_groups());
      writer.gap(core.shape.schedule);
   }
   writer.clocks.resize(clocks);
   std::ostringstream text;
   trace_core(core, {core.name, pixels, writer.clocks}, text);
   OutputFolder out(arguments.out);
   out.add("trace.txt", text.str());
   out.commit();
}

}  // namespace

void add_trace(CLI::App& app) {
   static TraceArguments arguments;
   CLI::App* command = app.add_subcommand("trace", "trace all registers of the clocked core: trace.txt");
   command->add_option("--config", arguments.config, "configuration")->required();
   command->add_option("--out", arguments.out, "folder for the result")->required();
   command->add_option("--clocks", arguments.clocks, "length")->check(CLI::Range(10, 1000000))->capture_default_str();
   command->callback([] { trace(arguments); });
}

}  // namespace stereo::app
