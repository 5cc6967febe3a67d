// SPDX-License-Identifier: Apache-2.0
// The hardware top of the rectification of a pair: plain ports around one core that never stops. One pass of the loop
// is one clock.
//    -DSTEREO_CONFIGURATION=rectify_vga
#include "rectification/configurations.hpp"
#include "rectification/core.hpp"
#include "support/pixel_bits.hpp"

namespace {
constexpr const auto& kConfig = stereo::rectification::configurations::STEREO_CONFIGURATION;
using Core = stereo::rectification::Core<kConfig>;
using Pixel = stereo::Pixel<kConfig>;

// Static, so that they start with zeros in hardware too.
template <class Word, int Depth, int Number>
Word memory_words[Depth];

struct Memories {
   template <class Word, int Depth, int Number>
   HLS_INLINE Word (&words())[Depth] {
      return memory_words<Word, Depth, Number>;
   }
};
}  // namespace

/// Pixels: pixel_bits bits each.
#pragma HLS interface port = left_pixel mode = none
#pragma HLS interface port = right_pixel mode = none
#pragma HLS interface port = start_of_frame mode = none
#pragma HLS interface port = valid mode = none
#pragma HLS interface port = node_valid mode = none
#pragma HLS interface port = node_right mode = none
#pragma HLS interface port = node_column mode = none
#pragma HLS interface port = node_row mode = none
#pragma HLS interface port = node_x mode = none
#pragma HLS interface port = node_y mode = none
#pragma HLS interface port = rectified_left mode = none
#pragma HLS interface port = rectified_right mode = none
#pragma HLS interface port = rectified_start_of_frame mode = none
#pragma HLS interface port = rectified_valid mode = none
extern "C" void rectification_core(volatile Pixel* left_pixel, volatile Pixel* right_pixel,
                                   volatile bool* start_of_frame, volatile bool* valid, volatile bool* node_valid,
                                   volatile bool* node_right, volatile uint16_t* node_column,
                                   volatile uint16_t* node_row, volatile uint16_t* node_x, volatile uint16_t* node_y,
                                   volatile Pixel* rectified_left, volatile Pixel* rectified_right,
                                   volatile bool* rectified_start_of_frame, volatile bool* rectified_valid) {
   Memories memories;
   Core core(memories);
#pragma nounroll
   while (true) {
      // Volatile accesses keep their order, and a read after a write or after the core's memory accesses costs a state:
      // all inputs first, then all outputs, then the clock.
      const Pixel left = *left_pixel;
      const Pixel right = *right_pixel;
      stereo::CoreInput<kConfig> in;
      in.left[0] = stereo::pixel_of<kConfig>(left, 0);
      in.right[0] = stereo::pixel_of<kConfig>(right, 0);
      in.start_of_frame = *start_of_frame;
      in.valid = *valid;
      stereo::rectification::TableWrite node;
      node.valid = *node_valid;
      node.right = *node_right;
      node.column = *node_column;
      node.row = *node_row;
      node.x = int16_t(*node_x);
      node.y = int16_t(*node_y);
      const stereo::CoreInput<kConfig> out = core.output();
      *rectified_left = out.left[0];
      *rectified_right = out.right[0];
      *rectified_start_of_frame = out.start_of_frame;
      *rectified_valid = out.valid;
      core.clock(in, node);
   }
}
