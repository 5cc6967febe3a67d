// SPDX-License-Identifier: Apache-2.0
#include "program/commands/configurations_command.hpp"

#include <CLI/CLI.hpp>
#include <iostream>

#include "engines/configurations.hpp"
#include "program/commands/configurations_json.hpp"

namespace stereo::app {
namespace {

void list_configurations(bool as_json_text) {
   if (as_json_text) {
      std::cout << configurations_json().dump(2) << '\n';
      return;
   }
   for (const Configuration& entry : configurations())
      std::cout << entry.name << ": " << entry.description() << ", output "
                << size_text(entry.shape.output_width_px, entry.shape.image.height_px) << ", latency "
                << entry.shape.schedule.latency_clocks << " clocks\n";
}

}  // namespace

void add_configurations(CLI::App& app) {
   static bool as_json = false;
   CLI::App* command = app.add_subcommand("configurations", "list the hardware configurations");
   command->add_flag("--json", as_json, "as JSON, for scripts");
   command->callback([] { list_configurations(as_json); });
}

}  // namespace stereo::app
