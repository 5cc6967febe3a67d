// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace stereo {

/// Whether the map of a configuration has all columns whose windows lie in the image, not only those at which the whole
/// disparity range fits (docs/algorithm.md, step 8). Families without the option do not.
template <const auto& C>
inline constexpr bool kFullWidth = [] {
   if constexpr (requires { C.full_width; }) return C.full_width;
   else return false;
}();

}  // namespace stereo
