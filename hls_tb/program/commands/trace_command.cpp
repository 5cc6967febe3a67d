// SPDX-License-Identifier: Apache-2.0
#include "program/commands/trace_command.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <sstream>

#include "engines/clocked/core_modules.hpp"
#include "engines/clocked/register_trace.hpp"
#include "engines/rectification/stage_stimulus.hpp"
#include "program/commands/named_matching.hpp"
#include "program/commands/stream_options.hpp"
#include "program/errors.hpp"
#include "program/io/output_folder.hpp"

namespace stereo::app {
namespace {

struct TraceArguments {
   std::string config, out;
   int first = 0, clocks = 1000;
   StreamArguments stream;
};

/// Leaves what lies behind the last clock that is asked for out of `clocks`, those of the stream.
template <class Clocks>
void cut(Clocks& clocks, const TraceArguments& arguments) {
   const std::size_t first = std::size_t(arguments.first);
   if (first >= clocks.size())
      throw InputError("--first-clock " + std::to_string(first) + ": the stream has " + std::to_string(clocks.size()) +
                       " clocks");
   clocks.resize(std::min(clocks.size(), first + std::size_t(arguments.clocks)));
}

void trace(const TraceArguments& arguments) {
   std::ostringstream text;
   const bool has_stream = arguments.stream.stress || !arguments.stream.left.empty();
   const uint64_t first = uint64_t(arguments.first);
   if (first > 0 && !has_stream) throw InputError("--first-clock needs --stress, or --left and --right");
   if (const Stage* const stage = find_stage(arguments.config)) {
      if (has_stream) {
         const Stimulus stream = make_stream(arguments.stream, stage->name, stage->shape).stimulus;
         std::vector<StageClock> clocks = make_stage_stimulus(*stage, stream, arguments.stream.options.seed);
         cut(clocks, arguments);
         trace_stage(*stage, clocks, text, first);
      } else {
         trace_stage(*stage, arguments.clocks, text);
      }
   } else {
      const CoreModule& core = core_module(require_configuration(arguments.config).name);
      const int clocks = arguments.clocks * core.shape.schedule.clocks_per_group;
      Stimulus stimulus = has_stream ? make_stream(arguments.stream, core.name, core.shape).stimulus
                                     : make_trace_stimulus(core.name, core.shape, clocks);
      if (has_stream) cut(stimulus.clocks, arguments);
      trace_core(core, stimulus, text, first);
   }
   OutputFolder out(arguments.out);
   out.add("trace.txt", text.str());
   out.commit();
}

}  // namespace

void add_trace(CLI::App& app) {
   static TraceArguments arguments;
   CLI::App* command = app.add_subcommand("trace",
                                          "write the values of all registers of a clocked core in every clock, for "
                                          "random pixels or for the stream of `vectors`: trace.txt");
   command->add_option("--config", arguments.config, "configuration")->required();
   command->add_option("--out", arguments.out, "folder for the result")->required();
   command->add_option("--clocks", arguments.clocks, "how many")->check(CLI::Range(10, 1000000))->capture_default_str();
   command->add_option("--first-clock", arguments.first, "first clock of the stream to write")
       ->check(CLI::Range(0, 1000000000))
       ->capture_default_str();
   add_stream_options(*command, arguments.stream);
   command->callback([] { trace(arguments); });
}

}  // namespace stereo::app
