// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>
#include <cmath>
#include <string>

namespace stereo::app {

/// An option's number above 0. CLI11's own check takes "nan" too.
inline std::string check_positive_number(const std::string& text) {
   double value = 0;
   const bool is_number = CLI::detail::lexical_cast(text, value);
   return is_number && std::isfinite(value) && value > 0 ? "" : text + " is no number above 0";
}

}  // namespace stereo::app
