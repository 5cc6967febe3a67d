// SPDX-License-Identifier: Apache-2.0
// What options of several commands must be.
#pragma once

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>

namespace stereo::app {

/// A number above 0. CLI11's own check takes "nan" too.
inline std::string check_positive_number(const std::string& text) {
   double value = 0;
   const bool is_number = CLI::detail::lexical_cast(text, value);
   return is_number && std::isfinite(value) && value > 0 ? "" : text + " is not a number above 0";
}

/// A number that is not "nan", which the check of a range lets pass.
inline std::string check_number(const std::string& text) {
   double value = 0;
   return CLI::detail::lexical_cast(text, value) && std::isfinite(value) ? "" : text + " is not a number";
}

/// A whole number that a seed can hold. CLI11 makes another number of a larger one.
inline std::string check_seed(const std::string& text) {
   const std::string largest = std::to_string(std::numeric_limits<uint64_t>::max());
   const bool is_number =
       !text.empty() && std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
   const std::string digits = is_number ? text.substr(std::min(text.find_first_not_of('0'), text.size() - 1)) : "";
   const bool fits = digits.size() < largest.size() || (digits.size() == largest.size() && digits <= largest);
   return is_number && fits ? "" : text + " is not a whole number of 0 ... " + largest;
}

/// Every option of every command refuses an empty value, which no option has a meaning for.
inline void refuse_empty_values(CLI::App& app) {
   for (CLI::App* command : app.get_subcommands([](CLI::App*) { return true; }))
      for (CLI::Option* option : command->get_options())
         if (option->get_items_expected_max() > 0)
            option->check(CLI::Validator(
                [](std::string& text) { return text.empty() ? std::string("must not be empty") : ""; }, ""));
}

}  // namespace stereo::app
