// SPDX-License-Identifier: Apache-2.0
// The hardware top: plain ports around one core that never stops. One pass of the loop is one clock.
// STEREO_CONFIGURATION names the configuration: -DSTEREO_CONFIGURATION=ambrosch2007
#include "stereo_core.hpp"

namespace {
using Core = stereo::StereoCore<stereo::configurations::STEREO_CONFIGURATION>;
// Static, so that they start with zeros in hardware too.
Core::ReferenceMemory reference_memory;
Core::RowMemory row_memory;
}  // namespace

#pragma HLS interface port = left_pixel mode = none
#pragma HLS interface port = right_pixel mode = none
#pragma HLS interface port = start_of_frame mode = none
#pragma HLS interface port = valid mode = none
#pragma HLS interface port = disparity mode = none
#pragma HLS interface port = disparity_valid mode = none
#pragma HLS interface port = disparity_start_of_frame mode = none
#pragma HLS interface port = disparity_end_of_line mode = none
extern "C" void stereo_core(volatile uint8_t* left_pixel, volatile uint8_t* right_pixel, volatile bool* start_of_frame,
                            volatile bool* valid, volatile uint8_t* disparity, volatile bool* disparity_valid,
                            volatile bool* disparity_start_of_frame, volatile bool* disparity_end_of_line) {
   Core core(reference_memory, row_memory);
#pragma nounroll
   while (true) {
      // Volatile accesses keep their order, and a read after a write or after the core's memory accesses costs a state:
      // all inputs first, then all outputs, then the clock.
      stereo::StereoInput in;
      in.left = *left_pixel;
      in.right = *right_pixel;
      in.start_of_frame = *start_of_frame;
      in.valid = *valid;
      const stereo::StereoOutput out = core.output();
      *disparity = out.disparity;
      *disparity_valid = out.valid;
      *disparity_start_of_frame = out.start_of_frame;
      *disparity_end_of_line = out.end_of_line;
      core.clock(in);
   }
}
