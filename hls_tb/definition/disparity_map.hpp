// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace stereo {

/// What a matcher gives: a disparity and a bit for each pixel, in raster order, row 0 first. Disparities count from
/// min_disparity, in pixels or, with `subpixel`, in sixteenths of a pixel.
struct DisparityMap {
   int width = 0;
   int height = 0;
   bool subpixel = false;
   std::vector<uint16_t> disparity;
   std::vector<uint8_t> valid;  ///< 1: the disparity has passed every check that is on, else 0

   DisparityMap() = default;
   /// All pixels valid.
   DisparityMap(int width_px, int height_px, uint16_t value = 0, bool in_sixteenths = false)
       : width(width_px),
         height(height_px),
         subpixel(in_sixteenths),
         disparity(std::size_t(width_px) * std::size_t(height_px), value),
         valid(disparity.size(), 1) {}

   uint16_t& at(int x, int y) { return disparity[index(x, y)]; }
   uint16_t at(int x, int y) const { return disparity[index(x, y)]; }
   uint8_t& valid_at(int x, int y) { return valid[index(x, y)]; }
   bool valid_at(int x, int y) const { return valid[index(x, y)] != 0; }
   /// Steps of a disparity in one pixel.
   int steps_per_pixel() const { return subpixel ? 16 : 1; }

   bool operator==(const DisparityMap&) const = default;

  private:
   std::size_t index(int x, int y) const { return std::size_t(y) * std::size_t(width) + std::size_t(x); }
};

}  // namespace stereo
