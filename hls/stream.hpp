// SPDX-License-Identifier: Apache-2.0
// What travels between the blocks, one record a clock.
#pragma once

#include <cstdint>

namespace stereo {

/// One pixel pair of a rectified stereo pair, in raster order, row 0 first.
struct StereoInput {
   uint8_t left = 0;             ///< grey value 0 ... 255
   uint8_t right = 0;            ///< grey value 0 ... 255
   bool start_of_frame = false;  ///< this is the pair at column 0 of row 0
   bool valid = false;           ///< false: a bubble; the core ignores the rest of the record
};

/// One pixel of the disparity map, in raster order; W-D pixels a row, H rows.
struct StereoOutput {
   uint8_t disparity = 0;        ///< 0 ... D-1, in pixels
   bool start_of_frame = false;  ///< this is the pixel at column 0 of row 0
   bool end_of_line = false;     ///< this is the last pixel of its row
   bool valid = false;           ///< false: no pixel leaves in this clock
};

/// What a pixel carries through the pipeline beside its data.
struct PixelTag {
   bool valid = false;           ///< a pixel pair, not a bubble: blocks with history move only then
   bool cost_column = false;     ///< the pair completes a cost column 0 ... W-D
   bool output_column = false;   ///< that cost column is the centre of an output pixel: 0 ... W-D-1, in an output row
   bool start_of_frame = false;  ///< the output pixel at column 0 of row 0
   bool end_of_line = false;     ///< the output pixel in column W-D-1
};

}  // namespace stereo
