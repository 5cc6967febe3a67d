// SPDX-License-Identifier: Apache-2.0
#include "program/commands/configurations_command.hpp"

#include <CLI/CLI.hpp>
#include <iostream>

#include "engines/configurations.hpp"
#include "engines/rectification/stages.hpp"
#include "program/commands/configurations_json.hpp"

namespace stereo::app {
namespace {

/// Entries: of Configuration or Stage.
template <class Entries>
void list(const Entries& entries) {
   for (const auto& entry : entries)
      std::cout << entry.name << ": " << entry.description() << ", output "
                << size_text(entry.shape.output_width_px, entry.shape.image.height_px) << ", latency "
                << entry.shape.schedule.latency_clocks << " clocks\n";
}

void list_configurations(bool as_json_text, bool of_stages) {
   if (as_json_text) std::cout << (of_stages ? stages_json() : configurations_json()).dump(2) << '\n';
   else if (of_stages) list(stages());
   else list(configurations());
}

}  // namespace

void add_configurations(CLI::App& app) {
   static bool as_json = false, of_stages = false;
   CLI::App* command = app.add_subcommand("configurations", "list the hardware configurations");
   command->add_flag("--json", as_json, "as JSON, for scripts");
   command->add_flag("--stages", of_stages, "list the stages in front of a matching core instead");
   command->callback([] { list_configurations(as_json, of_stages); });
}

}  // namespace stereo::app
