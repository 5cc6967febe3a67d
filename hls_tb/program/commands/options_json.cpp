// SPDX-License-Identifier: Apache-2.0
#include "program/commands/options_json.hpp"

#include <algorithm>

#include "program/errors.hpp"

namespace stereo::app {

const char* word_of(Reference reference) { return Words<Reference>::kWords[std::size_t(reference)]; }

const std::map<std::string, Reference>& reference_words() {
   static const std::map<std::string, Reference> words{{word_of(Reference::left), Reference::left},
                                                       {word_of(Reference::right), Reference::right}};
   return words;
}

nlohmann::json options_json(const std::vector<OptionValue>& options) {
   nlohmann::json json = nlohmann::json::object();
   for (const OptionValue& option : options)
      std::visit([&](const auto& value) { json[option.name] = value; }, option.value);
   return json;
}

void for_each_setting(const std::vector<std::string>& settings,
                      const std::function<void(const std::string& name, const std::string& value)>& set) {
   std::vector<std::string> names;
   for (const std::string& setting : settings) {
      const std::size_t equals = setting.find('=');
      if (equals == std::string::npos)
         throw InputError("--set " + setting + ": must be NAME=VALUE, such as window_px=9");
      const std::string name = setting.substr(0, equals);
      if (std::ranges::find(names, name) != names.end())
         throw InputError("--set " + setting + ": " + name + " is set twice");
      names.push_back(name);
      try {
         set(name, setting.substr(equals + 1));
      } catch (const std::invalid_argument& problem) {
         throw InputError("--set " + setting + ": " + problem.what());
      }
   }
}

std::shared_ptr<const Algorithm> with_options(std::shared_ptr<const Algorithm> algorithm,
                                              const std::vector<std::string>& settings) {
   for_each_setting(settings, [&algorithm](const std::string& name, const std::string& value) {
      algorithm = algorithm->with(name, value);
   });
   return algorithm;
}

}  // namespace stereo::app
