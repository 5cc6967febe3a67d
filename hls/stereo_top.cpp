// SPDX-License-Identifier: Apache-2.0
// The hardware top: plain ports around one core that never stops. One pass of the loop is one clock.
// STEREO_CONFIGURATION names the configuration: -DSTEREO_CONFIGURATION=ambrosch2007
#include "stereo_core.hpp"

namespace {
constexpr const stereo::StereoConfig& kConfig = stereo::configurations::STEREO_CONFIGURATION;
// Static, so that they start with zeros in hardware too.
stereo::ReferenceDelay<kConfig>::Memory reference_memory;
stereo::LineBuffer<kConfig>::Memory row_memory;
}  // namespace

#pragma HLS interface port = left mode = none
#pragma HLS interface port = right mode = none
#pragma HLS interface port = start_of_frame mode = none
#pragma HLS interface port = valid mode = none
#pragma HLS interface port = disparity mode = none
#pragma HLS interface port = out_flags mode = none
extern "C" void stereo_core(volatile uint8_t* left, volatile uint8_t* right, volatile uint8_t* start_of_frame,
                            volatile uint8_t* valid, volatile uint8_t* disparity, volatile uint8_t* out_flags) {
   stereo::StereoCore<kConfig> core(reference_memory, row_memory);
#pragma nounroll
   while (true) {
      // All inputs before all outputs: volatile accesses keep their order, and a read after a write costs a state.
      stereo::StereoInput in;
      in.left = *left;
      in.right = *right;
      in.start_of_frame = *start_of_frame & 1;
      in.valid = *valid & 1;
      const stereo::StereoOutput out = core.clock(in);
      *disparity = out.disparity;
      *out_flags = uint8_t(out.valid) | uint8_t(out.start_of_frame << 1) | uint8_t(out.end_of_line << 2);
   }
}
