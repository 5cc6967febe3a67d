// SPDX-License-Identifier: Apache-2.0
// Calibrations that OpenCV's reader does not know. Any bytes are safe.
#pragma once

#include <optional>
#include <string>

#include "program/depth/calibration.hpp"

namespace stereo::app {

/// Of ROS, Kalibr, MATLAB or a benchmark, told by the content; nothing where it is none of them. Throws InputError with
/// one sentence, without a file name.
std::optional<Calibration> parse_calibration(const std::string& text);

/// A file and its name for the user.
struct NamedText {
   std::string name, text;
};
/// Of two files, one of each camera: camera_info of ROS. Throws InputError with one sentence that begins with the name.
Calibration parse_calibrations(const NamedText& left, const NamedText& right);

}  // namespace stereo::app
