// SPDX-License-Identifier: Apache-2.0
#include "program/commands/options_command.hpp"

#include <CLI/CLI.hpp>
#include <iostream>
#include <string>

#include "program/commands/configurations_json.hpp"

namespace stereo::app {
namespace {

/// "8 ... 4096", "at least 1", "left, right".
std::string limits_of(const nlohmann::json& option) {
   if (!option.contains("words")) {
      const nlohmann::json &low = option["low"], &high = option["high"];
      if (high.is_null()) return low.is_null() ? "any" : "at least " + low.dump();
      return (low.is_null() ? "up to " : low.dump() + " ... ") + high.dump();
   }
   std::string words;
   for (const nlohmann::json& word : option["words"]) words += (words.empty() ? "" : ", ") + word.get<std::string>();
   return words;
}

void list(bool as_json) {
   const nlohmann::json all = all_options_json();
   if (as_json) {
      std::cout << all.dump(2) << '\n';
      return;
   }
   for (const auto& [family, options] : all.items()) {
      std::cout << family << ":\n";
      for (const auto& [name, option] : options.items()) {
         const nlohmann::json& standard = option["default"];
         std::cout << "  " << name << ' ' << (standard.is_string() ? standard.get<std::string>() : standard.dump())
                   << " (" << limits_of(option) << ")\n";
      }
   }
}

}  // namespace

void add_options(CLI::App& app) {
   static bool as_json = false;
   CLI::App* command = app.add_subcommand("options", "list the options of each family, with defaults and limits");
   command->add_flag("--json", as_json, "as JSON, for scripts");
   command->callback([] { list(as_json); });
}

}  // namespace stereo::app
