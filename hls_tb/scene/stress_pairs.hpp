// SPDX-License-Identifier: Apache-2.0
// Image pairs that are made to find faults in hardware, not to look like anything.
#pragma once

#include <array>

#include "definition/gray_image.hpp"
#include "scene/random.hpp"

namespace stereo {

/// What a pair brings, and the faults that need it. "Matched": left(x + d, y) = right(x, y) for some d of the search
/// range.
enum class StressClass {
   scene,       ///< surfaces with texture: most values of every register
   noise,       ///< all grey levels, unrelated: large costs
   few_levels,  ///< 2 to 5 levels, far apart or next to each other: ties everywhere
   blocks,      ///< black and white rectangles, matched, unrelated or inverted: sums at both ends of their range
   steps,       ///< texture matched at disparities that jump between the first and the last of the range
   edges,       ///< the same with the jumps from one end of the range to the other, and beyond it
   stairs,      ///< the same in short steps to neighbours, at both ends of the range
   periodic,    ///< the same pattern again and again: ties between disparities that lie apart
   constant,    ///< one level, also black or white, with a few other pixels: no texture
   opposed,     ///< one image bright where the other is dark: the largest cost in all windows
   slopes,      ///< one image rises where the other falls: all bits of a census differ, for all costs of all windows
   ramp,        ///< slopes that are matched or not: costs that rise and fall by little, subpixel steps
   patchwork,   ///< rectangles of the other classes
   rough,       ///< slopes with noise: the largest costs of a census, no two disparities alike
   tiles,       ///< each matched at a disparity of its own: paths from the left, the right and above that want others
   contrary,    ///< tiles in which another disparity has the largest costs: paths that lie as far apart as they can
   bands,       ///< black and white, two columns wide, matched: where few disparities are searched, the second best one
                ///< is as far above the best one as it can be
   enlarged,    ///< another class, four times as large: what a search in coarse images sees
};

/// Of each stream.
inline constexpr std::array kStressClasses{
    StressClass::scene,  StressClass::noise,  StressClass::few_levels, StressClass::blocks,   StressClass::steps,
    StressClass::edges,  StressClass::stairs, StressClass::periodic,   StressClass::constant, StressClass::opposed,
    StressClass::slopes, StressClass::ramp,   StressClass::patchwork,
};

/// Of the last stream only.
inline constexpr std::array kLastStressClasses{StressClass::rough, StressClass::tiles, StressClass::contrary,
                                               StressClass::bands, StressClass::enlarged};

inline constexpr std::array kAllStressClasses = [] {
   std::array<StressClass, kStressClasses.size() + kLastStressClasses.size()> all{};
   std::size_t i = 0;
   for (const StressClass kind : kStressClasses) all[i++] = kind;
   for (const StressClass kind : kLastStressClasses) all[i++] = kind;
   return all;
}();

/// What the pair must fit.
struct StressShape {
   int width, height;    ///< px
   int first_disparity;  ///< of the search range, in pixels; may be negative
   int disparities;      ///< that it has
   int pixel_bits = 8;   ///< of a grey value
};

/// A pair of the class; another one with each call.
DeepPair stress_pair(StressClass kind, const StressShape& shape, Random& random);

}  // namespace stereo
