// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <ostream>
#include <string>

#include "vectors/heap_memories.hpp"
#include "vectors/lane_word.hpp"
#include "vectors/register_names.hpp"
#include "vectors/stimulus.hpp"

namespace stereo {

/// Writes what every port and register of a core shows in each clock, before the clock edge:
/// "stereo-hls trace 1 config=NAME clocks=N", a line with the names, then N lines of hexadecimal values,
/// -1f for -31. Pixel ports are words as in the vector files.
template <const StereoConfig& C>
void trace_core(const Stimulus& stimulus, std::ostream& out) {
   HeapMemories memories;
   const auto core = std::make_unique<StereoCore<C>>(memories);
   out << "stereo-hls trace 1 config=" << stimulus.config << " clocks=" << stimulus.clocks.size() << '\n'
       << "in_left_pixel in_right_pixel in_start_of_frame in_valid "
          "out_disparity out_pixel_valid out_disparity_valid out_disparity_start_of_frame out_disparity_end_of_line";
   for_each_register(*core, [&out](const std::string& name, uint64_t, bool) { out << ' ' << name; });
   out << '\n' << std::hex;
   for (const StereoInput& in : stimulus.clocks) {
      const StereoOutput shown = core->output();
      const auto word = [](const uint8_t(&lanes)[kMostPixels]) {
         return lane_word<uint8_t>(lanes, C.pixels_per_clock, 8);
      };
      out << word(in.left) << ' ' << word(in.right) << ' ' << in.start_of_frame << ' ' << in.valid << ' '
          << lane_word<uint16_t>(shown.disparity, C.pixels_per_clock, C.disparity_bits()) << ' '
          << lane_word<bool>(shown.pixel_valid, C.pixels_per_clock, 1) << ' ' << shown.valid << ' '
          << shown.start_of_frame << ' ' << shown.end_of_line;
      for_each_register(*core, [&out](const std::string&, uint64_t value, bool negative) {
         out << (negative ? " -" : " ") << (negative ? ~value + 1 : value);
      });
      out << '\n';
      core->clock(in);
   }
}

}  // namespace stereo
