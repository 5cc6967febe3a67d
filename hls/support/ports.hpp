// SPDX-License-Identifier: Apache-2.0
// What goes into a core and comes out of it, one record a clock.
#pragma once

#include <cstdint>

namespace stereo {

/// Most pixel pairs that a core takes in one clock. A core with fewer leaves the other elements alone.
inline constexpr int kMostPixels = 4;

/// One column of P neighbouring rows of a rectified stereo pair. Columns come in raster order: column 0 ... W-1 of the
/// first P rows, then of the next P rows.
template <class Pixel>
struct PixelPairs {
   Pixel left[kMostPixels] = {};   ///< grey values, [0] is the upper row
   Pixel right[kMostPixels] = {};  ///< grey values
   bool start_of_frame = false;    ///< this is column 0 of the first rows
   bool valid = false;             ///< false: a bubble; the core ignores the rest of the record

   /// The same record for a core with pixels of another type, which holds them.
   template <class Other>
   constexpr operator PixelPairs<Other>() const {
      PixelPairs<Other> record{.start_of_frame = start_of_frame, .valid = valid};
      for (int p = 0; p < kMostPixels; ++p) {
         record.left[p] = Other(left[p]);
         record.right[p] = Other(right[p]);
      }
      return record;
   }
};

/// Of a core that takes pixels of 8 bits.
using StereoInput = PixelPairs<uint8_t>;
/// With room for the pixels of every core.
using WideInput = PixelPairs<uint16_t>;

/// One column of P neighbouring rows of the disparity map, in the same order.
struct StereoOutput {
   uint16_t disparity[kMostPixels] = {};  ///< above min_disparity, in pixels or, with subpixel, their sixteenths
   bool pixel_valid[kMostPixels] = {};    ///< the disparity has passed every check that the configuration has
   bool start_of_frame = false;           ///< this is column 0 of the first rows
   bool end_of_line = false;              ///< this is the last column of its rows
   bool valid = false;                    ///< false: no pixels leave in this clock
};

/// The same of a core with post-processing.
struct PostOutput : StereoOutput {
   uint8_t confidence[kMostPixels] = {};  ///< with `confidence`: 255 is the surest, 0 where not valid
   bool filled[kMostPixels] = {};         ///< with `fill_holes`: not valid, shows what stands beside it
};

/// What the word of an output has for each row beside the disparity, which then has 15 bits or fewer: in bit 15 whether
/// the pixel was filled, and in the 8 bits above 8 or 16 the confidence.
struct LaneLayout {
   int bits = 8;  ///< of a row: 8, 16 or 24
   bool has_confidence = false, has_filled = false;

   constexpr uint32_t lane(uint16_t disparity, uint8_t confidence, bool filled) const {
      uint32_t word = disparity;
      if (has_filled) word |= uint32_t(filled) << 15;
      if (has_confidence) word |= uint32_t(confidence) << (bits - 8);
      return word;
   }
};

}  // namespace stereo
