// SPDX-License-Identifier: Apache-2.0
// Which files of two cameras' folders belong together.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace stereo::app {

/// Numbers in the names count as numbers: 2.png before 10.png.
void sort_by_number(std::vector<std::string>& names);

struct PairedNames {
   std::vector<std::pair<std::string, std::string>> pairs;  ///< in the order of their numbers and names
   std::vector<std::string> left_alone, right_alone;        ///< without a partner
};

/// Pairs by whole names, by names without their endings and leading zeros, by all numbers in them, by the last number
/// or by the first one: the first of these that pairs most frames and tells all frames of a camera apart.
PairedNames pair_names(const std::vector<std::string>& left, const std::vector<std::string>& right);

}  // namespace stereo::app
