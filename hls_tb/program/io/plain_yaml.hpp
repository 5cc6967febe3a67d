// SPDX-License-Identifier: Apache-2.0
// The part of YAML that calibrations of ROS and Kalibr are written in. OpenCV's reader takes only files that begin with
// %YAML, and comes back from neither of them.
#pragma once

#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string_view>

namespace stereo::app {

/// One document of mappings and sequences by indentation, [ ] and { } over any number of lines, plain and quoted words
/// and comments; tags are skipped. Words, also numbers, are strings, and what is empty is an empty string. Throws
/// std::invalid_argument, with a text that begins "line N: ", on anything else: several documents, a key twice,
/// anchors, texts of several lines, tabs as indentation.
nlohmann::json parse_plain_yaml(std::string_view text);

}  // namespace stereo::app
