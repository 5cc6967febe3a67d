// SPDX-License-Identifier: Apache-2.0
#include "program/commands/trace_command.hpp"

#include <CLI/CLI.hpp>
#include <sstream>

#include "engines/clocked/core_modules.hpp"
#include "engines/clocked/register_trace.hpp"
#include "engines/rectification/stage_stimulus.hpp"
#include "program/commands/named_matching.hpp"
#include "program/io/output_folder.hpp"

namespace stereo::app {
namespace {

struct TraceArguments {
   std::string config, out;
   int clocks = 1000;
};

void trace(const TraceArguments& arguments) {
   std::ostringstream text;
   if (const Stage* const stage = find_stage(arguments.config)) {
      trace_stage(*stage, arguments.clocks, text);
   } else {
      const CoreModule& core = core_module(require_configuration(arguments.config).name);
      trace_core(core, make_trace_stimulus(core.name, core.shape, arguments.clocks), text);
   }
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
