// SPDX-License-Identifier: Apache-2.0
// What comes out of a core, clock by clock, and the maps that it makes.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "definition/disparity_map.hpp"
#include "engines/clocked/core_shape.hpp"
#include "support/ports.hpp"

namespace stereo {

/// A valid output of a core: one column of a group of rows.
struct CoreOutput {
   uint64_t clock = 0;  ///< 0-based index of the clock() call that returned it
   int x = -1, y = -1;  ///< of lane 0, by start of frame and ends of lines, not by the clock
   int frame = -1;      ///< from 0; -1 before the first start of frame
   // [p]: at (x, y + p)
   std::array<uint16_t, kMostPixels> disparity{};
   std::array<bool, kMostPixels> pixel_valid{};
   std::array<uint8_t, kMostPixels> confidence{};
   std::array<bool, kMostPixels> filled{};
   bool start_of_frame = false;
   bool end_of_line = false;

   bool operator==(const CoreOutput&) const = default;
};

/// Gives the outputs of a core their places, in the order in which they come.
class OutputLocator {
  public:
   explicit OutputLocator(int pixels_per_clock) : pixels_per_clock_(pixels_per_clock) {}
   CoreOutput locate(uint64_t clock, const PostOutput& output);
   CoreOutput locate(uint64_t clock, const StereoOutput& output) { return locate(clock, PostOutput{output, {}, {}}); }

  private:
   int pixels_per_clock_;
   CoreOutput last_;
};

/// One disparity map a frame. Throws std::runtime_error unless every frame has each pixel exactly once, in raster
/// order.
std::vector<DisparityMap> collect_frames(std::span<const CoreOutput> outputs, const CoreShape& core);

}  // namespace stereo
