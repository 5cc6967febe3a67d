// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace stereo {

/// What a matcher gives: a disparity and a bit for each pixel, in raster order, row 0 first. Disparities count from
/// min_disparity, in pixels or, with `subpixel`, in sixteenths of a pixel. Post-processing may add more.
struct DisparityMap {
   int width = 0;
   int height = 0;
   bool subpixel = false;
   std::vector<uint16_t> disparity;
   std::vector<uint8_t> valid;       ///< 1: the disparity has passed every check that is on, else 0
   std::vector<uint8_t> confidence;  ///< 0 ... 255, 0 where not valid; empty where the matcher gives none
   std::vector<uint8_t> filled;      ///< 1: not valid, but it shows what stands beside it; empty where none does

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
   uint8_t& confidence_at(int x, int y) { return confidence[index(x, y)]; }
   uint8_t& filled_at(int x, int y) { return filled[index(x, y)]; }
   /// Measured or filled.
   bool has_value_at(int x, int y) const { return valid_at(x, y) || (!filled.empty() && filled[index(x, y)] != 0); }
   /// Steps of a disparity in one pixel.
   int steps_per_pixel() const { return subpixel ? 16 : 1; }

   bool operator==(const DisparityMap&) const = default;

  private:
   std::size_t index(int x, int y) const { return std::size_t(y) * std::size_t(width) + std::size_t(x); }
};

}  // namespace stereo
