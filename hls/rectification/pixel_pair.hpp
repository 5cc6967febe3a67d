// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "support/pixel_bits.hpp"
#include "support/registers.hpp"

namespace stereo::rectification {

/// A pixel of each camera as it came in.
template <const auto& C>
struct PixelPair {
   Pixel<C> left, right;
   bool start_of_frame, valid;

   /// Member by member: the tool would copy the record as one word of 32 bits, and registers of words have no names.
   HLS_INLINE PixelPair& operator=(const PixelPair& other) {
      left = other.left;
      right = other.right;
      start_of_frame = other.start_of_frame;
      valid = other.valid;
      return *this;
   }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("left", left);
      visit("right", right);
      visit("start_of_frame", start_of_frame);
      visit("valid", valid);
   }
};

template <const auto& C>
HLS_INLINE PixelPair<C> pixel_pair(const CoreInput<C>& in) {
   return {in.left[0], in.right[0], in.start_of_frame, in.valid};
}

}  // namespace stereo::rectification
