// SPDX-License-Identifier: Apache-2.0
#include "program/commands/configurations_json.hpp"

#include "engines/configurations.hpp"
#include "engines/families.hpp"
#include "engines/rectification/stages.hpp"
#include "program/commands/options_json.hpp"

namespace stereo::app {
namespace {

nlohmann::json json_of(const OptionLimits& option) {
   nlohmann::json json;
   std::visit([&](const auto& value) { json["default"] = value; }, option.standard.value);
   if (!option.words.empty()) {
      json["words"] = option.words;
      return json;
   }
   json["low"] = option.low ? nlohmann::json(*option.low) : nlohmann::json();
   json["high"] = option.high ? nlohmann::json(*option.high) : nlohmann::json();
   json["meaning"] = option.meaning;
   return json;
}

nlohmann::json json_of(const std::vector<OptionLimits>& options) {
   nlohmann::json json;
   for (const OptionLimits& option : options) json[option.standard.name] = json_of(option);
   return json;
}

/// Entry: Configuration or Stage.
template <class Entry>
nlohmann::json common_json(const Entry& entry) {
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
                {"output_width_px", shape.output_width_px},
                {"output_height_px", shape.image.height_px},
                {"latency_clocks", shape.schedule.latency_clocks},
                {"groups_to_first_output", shape.schedule.groups_to_first_output},
                {"flush_groups", shape.schedule.flush_groups},
                {"gap_groups", shape.schedule.gap_groups}});
   for (const Setting& setting : shape.settings) {
      json["settings"].push_back(
          {{"name", setting.name}, {"bits", setting.bits}, {"largest", setting.largest}, {"start", setting.start}});
      if (setting.least > 0) json["settings"].back().update({{"least", setting.least}});
      if (setting.held)
         json["settings"].back().update({{"least", setting.least}, {"step", setting.step}, {"held", true}});
   }
   return json;
}

nlohmann::json as_json(const Configuration& entry) {
   nlohmann::json json = common_json(entry);
   const MapGeometry geometry = entry.algorithm->map_geometry(entry.shape.image.width_px);
   json["disparities"] = geometry.disparities;
   json["output_first_column"] = geometry.first_column;
   json["disparity_bits"] = entry.shape.disparity_bits;
   return json;
}

nlohmann::json as_json(const Stage& entry) {
   nlohmann::json json = common_json(entry);
   json["table_columns"] = entry.config.table_columns();
   json["table_rows"] = entry.config.table_rows();
   json["lag_rows"] = entry.config.lag_rows();
   return json;
}

}  // namespace

nlohmann::json configurations_json() {
   nlohmann::json all;
   for (const Configuration& entry : configurations()) all[entry.name] = as_json(entry);
   return all;
}

nlohmann::json stages_json() {
   nlohmann::json all;
   for (const Stage& entry : stages()) all[entry.name] = as_json(entry);
   return all;
}

nlohmann::json families_json() {
   nlohmann::json all;
   for (const Family& family : families()) all[family.name] = json_of(family.defaults->limits());
   return all;
}

nlohmann::json all_options_json() {
   nlohmann::json all;
   for (const Family& family : families()) all[family.name] = json_of(family.options);
   all[stages().front().family] = json_of(option_limits(rectification::Config()));
   return all;
}

}  // namespace stereo::app
