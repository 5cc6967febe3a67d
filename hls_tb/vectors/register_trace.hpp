// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <ostream>
#include <string>

#include "vectors/register_names.hpp"
#include "vectors/stimulus.hpp"

namespace stereo {

/// Writes what every port and register of a core shows in each clock, before the clock edge:
/// "stereo-hls trace 1 config=NAME clocks=N", a line with the names, then N lines of hexadecimal values.
template <const StereoConfig& C>
void trace_core(const Stimulus& stimulus, std::ostream& out) {
   const auto memories = std::make_unique<StereoMemories<C>>();
   const auto core = std::make_unique<StereoCore<C>>(memories->reference, memories->rows);
   out << "stereo-hls trace 1 config=" << stimulus.config << " clocks=" << stimulus.clocks.size() << '\n'
       << "in_left_pixel in_right_pixel in_start_of_frame in_valid "
          "out_disparity out_disparity_valid out_disparity_start_of_frame out_disparity_end_of_line";
   for_each_register(*core, [&out](const std::string& name, uint64_t) { out << ' ' << name; });
   out << '\n' << std::hex;
   for (const StereoInput& in : stimulus.clocks) {
      const StereoOutput shown = core->output();
      out << +in.left << ' ' << +in.right << ' ' << in.start_of_frame << ' ' << in.valid << ' ' << +shown.disparity
          << ' ' << shown.valid << ' ' << shown.start_of_frame << ' ' << shown.end_of_line;
      for_each_register(*core, [&out](const std::string&, uint64_t value) { out << ' ' << value; });
      out << '\n';
      core->clock(in);
   }
}

}  // namespace stereo
