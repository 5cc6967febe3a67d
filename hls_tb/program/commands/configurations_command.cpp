// SPDX-License-Identifier: Apache-2.0
#include "program/commands/configurations_command.hpp"

#include <CLI/CLI.hpp>
#include <iostream>

#include "engines/configurations.hpp"
#include "program/commands/options_json.hpp"

namespace stereo::app {
namespace {

nlohmann::json as_json(const Configuration& entry) {
   const CoreShape& shape = entry.shape;
   nlohmann::json json = options_json(entry.options), changed = nlohmann::json::array();
   for (const OptionValue& option : entry.changed)
      std::visit(
          [&](const auto& value) {
             const nlohmann::json text = value;
             changed.push_back(option.name + " " + (text.is_string() ? text.get<std::string>() : text.dump()));
          },
          option.value);
   json.update({{"family", entry.family},
                {"use", entry.use},
                {"source_folder", entry.source_folder},
                {"description", entry.description()},
                {"options", changed},
                {"disparities", entry.algorithm->map_geometry(shape.image.width_px).disparities},
                {"disparity_bits", shape.disparity_bits},
                {"output_width_px", shape.output_width_px},
                {"output_height_px", shape.image.height_px},
                {"latency_clocks", shape.schedule.latency_clocks},
                {"groups_to_first_output", shape.schedule.groups_to_first_output},
                {"flush_groups", shape.schedule.flush_groups},
                {"gap_groups", shape.schedule.gap_groups}});
   return json;
}

void list_configurations(bool as_json_text) {
   if (as_json_text) {
      nlohmann::json all;
      for (const Configuration& entry : configurations()) all[entry.name] = as_json(entry);
      std::cout << all.dump(2) << '\n';
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
