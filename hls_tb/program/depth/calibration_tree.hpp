// SPDX-License-Identifier: Apache-2.0
// What the readers of calibrations in YAML and JSON share. All throw InputError with one sentence, without a file name.
#pragma once

#include <nlohmann/json.hpp>
#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

#include "program/depth/calibration.hpp"

namespace stereo::app {

/// JSON, or what parse_plain_yaml makes of YAML, where numbers are strings.
using Tree = nlohmann::json;

/// A member, or nothing. Any of some names.
const Tree* member(const Tree& tree, std::initializer_list<const char*> names);
/// The first of the names in the sentence where there is none.
const Tree& required_member(const Tree& tree, std::initializer_list<const char*> names);

/// A list of finite numbers, not nested. `name`: for the user.
std::vector<double> numbers_of(const Tree& node, const std::string& name);
/// A list of lists; a list of all, row by row; or a mapping of rows, cols and data.
cv::Mat matrix_of(const Tree& node, int rows, int columns, const std::string& name);
/// A word; empty where there is none.
std::string word_at(const Tree& tree, const char* name);

/// A side of 1 ... 65536 pixels.
int side_of(double side, const std::string& name);

/// {the model of a word as ROS, Kalibr and OpenCV's users have it}; unsaid for an empty word.
Lens lens_of_word(const std::string& word);
/// Coefficients that fit the model, as OpenCV has them; empty where there are none.
cv::Mat distortion_of(const std::vector<double>& coefficients, Lens lens, const std::string& name);

}  // namespace stereo::app
