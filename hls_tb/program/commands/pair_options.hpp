// SPDX-License-Identifier: Apache-2.0
// Options that commands share which take a pair at a configuration's size.
#pragma once

#include <CLI/CLI.hpp>
#include <map>
#include <string>

#include "program/io/images.hpp"

namespace stereo::app {

/// An option whose words stand for values. The words must stay where they are.
template <class Value>
void add_choice(CLI::App& command, const std::string& option, Value& value, const std::map<std::string, Value>& words,
                const std::string& help) {
   command
       .add_option_function<std::string>(
           option, [&value, &words](const std::string& word) { value = words.at(word); }, help)
       ->check(CLI::IsMember(&words));
}

inline void add_pair_options(CLI::App& command, std::string& left, std::string& right, Fit& fit) {
   static const std::map<std::string, Fit> kFits{{"none", Fit::none}, {"crop", Fit::crop}, {"resize", Fit::resize}};
   command.add_option("--left", left, "left image of the rectified pair")->required();
   command.add_option("--right", right, "right image")->required();
   add_choice(command, "--fit", fit, kFits,
              "images of another size than the configuration's: none (default), crop or resize");
}

}  // namespace stereo::app
