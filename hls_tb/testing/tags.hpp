// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ostream>
#include <tuple>

#include "frontend/pixel_tag.hpp"
#include "scene/random.hpp"

namespace stereo {

inline auto members(const PixelTag& tag) {
   return std::tie(tag.valid, tag.row_start, tag.first_group, tag.border_column, tag.first_cost, tag.leaves_window,
                   tag.map_column, tag.output_column, tag.first_column, tag.start_of_frame, tag.end_of_line);
}

inline bool operator==(const PixelTag& a, const PixelTag& b) { return members(a) == members(b); }

/// The members in their order, 0 or 1.
inline std::ostream& operator<<(std::ostream& out, const PixelTag& tag) {
   std::apply([&out](const auto&... member) { (out << ... << int(member)); }, members(tag));
   return out;
}

namespace test {

/// Any tag; a quarter are bubbles.
inline PixelTag random_tag(Random& random) {
   PixelTag tag;
   tag.valid = !random.percent(25);
   for (bool* member : {&tag.row_start, &tag.first_group, &tag.border_column, &tag.first_cost, &tag.leaves_window,
                        &tag.map_column, &tag.output_column, &tag.first_column, &tag.start_of_frame, &tag.end_of_line})
      *member = random.percent(50);
   return tag;
}

/// What a window must know of its centre.
inline bool same_centre(const PixelTag& a, const PixelTag& b) {
   return a.valid == b.valid && a.map_column == b.map_column && a.output_column == b.output_column &&
          a.first_column == b.first_column && a.start_of_frame == b.start_of_frame && a.end_of_line == b.end_of_line;
}

}  // namespace test
}  // namespace stereo
