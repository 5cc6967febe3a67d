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

}  // namespace stereo
