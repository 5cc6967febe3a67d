// SPDX-License-Identifier: Apache-2.0
#include "program/commands/options_command.hpp"

#include <CLI/CLI.hpp>
#include <iostream>
#include <string>
#include <vector>

#include "program/commands/configurations_json.hpp"
#include "program/commands/named_matching.hpp"
#include "program/commands/options_json.hpp"

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

std::string word_of(const nlohmann::json& value) { return value.is_string() ? value.get<std::string>() : value.dump(); }

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
         std::cout << "  " << name << ' ' << word_of(standard) << " (" << limits_of(option) << ")\n";
      }
   }
}

void show(const Algorithm& algorithm, bool as_json) {
   const nlohmann::json options = options_json(algorithm.options());
   if (as_json) std::cout << options.dump(2) << '\n';
   else
      for (const auto& [name, value] : options.items()) std::cout << name << ' ' << word_of(value) << '\n';
}

struct Arguments {
   std::string config;
   std::vector<std::string> settings;
   bool as_json = false;
};

}  // namespace

void add_options(CLI::App& app) {
   static Arguments arguments;
   CLI::App* command = app.add_subcommand(
       "options", "list the options of each family, with defaults and limits, or those of a configuration's algorithm");
   CLI::Option* const config =
       command->add_option("--config", arguments.config, "a configuration: its options, of those that --set takes");
   command
       ->add_option("--set", arguments.settings,
                    "NAME=VALUE: override an option of it; what cannot be is refused, for images of any size")
       ->needs(config)
       ->allow_extra_args(false);
   command->add_flag("--json", arguments.as_json, "as JSON, for scripts");
   command->callback([] {
      if (arguments.config.empty()) list(arguments.as_json);
      else show(*named_algorithm(arguments.config, arguments.settings), arguments.as_json);
   });
}

}  // namespace stereo::app
