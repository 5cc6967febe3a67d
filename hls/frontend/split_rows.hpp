// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "support/registers.hpp"

namespace stereo {

/// What `full_width` needs where one image is held back: at the start of a row that image still shows the end of the
/// row before. Records of their own, so that a core without the option has nothing of them.
template <int Taps>
struct SplitRows {
   bool search_inside[Taps];  ///< [t]: of the searched image; the block's `row_inside` is of the reference then
   bool inside_before[Taps];  ///< [t]: of the row before, as the following
   bool output_before, first_before, start_before;
   bool whole_before;  ///< the row before was not broken off

   HLS_INLINE SplitRows() { start(*this); }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("search_inside", search_inside);
      visit("inside_before", inside_before);
      visit("output_before", output_before);
      visit("first_before", first_before);
      visit("start_before", start_before);
      visit("whole_before", whole_before);
   }
};

/// The part of it that follows the rows through their memories.
template <int Taps>
struct SearchInside {
   bool inside[Taps];

   HLS_INLINE SearchInside() { start(*this); }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("inside", inside);
   }
};

struct NoSplitRows {};

}  // namespace stereo
