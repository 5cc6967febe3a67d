// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "definition/disparity_map.hpp"
#include "definition/map_geometry.hpp"

namespace stereo::app {

/// The value of a pixel that has no disparity: no ground truth, or nothing found.
inline constexpr float kNoDisparity = std::numeric_limits<float>::quiet_NaN();
inline bool has_disparity(float value) { return !std::isnan(value); }

/// Disparities in pixels, one for each pixel of an image, in raster order, row 0 first.
struct DisparityImage {
   int width = 0;
   int height = 0;
   std::vector<float> px;

   DisparityImage() = default;
   DisparityImage(int width_px, int height_px, float value = kNoDisparity)
       : width(width_px), height(height_px), px(std::size_t(width_px) * std::size_t(height_px), value) {}

   float& at(int x, int y) { return px[index(x, y)]; }
   float at(int x, int y) const { return px[index(x, y)]; }
   template <class Image>
   bool same_size(const Image& other) const {
      return width == other.width && height == other.height;
   }

  private:
   std::size_t index(int x, int y) const { return std::size_t(y) * std::size_t(width) + std::size_t(x); }
};

/// A map at the size of its reference image, disparities counted from 0. Pixels outside the map and those
/// that have not passed a check have none, unless they were filled.
inline DisparityImage at_image_size(const DisparityMap& map, const MapGeometry& geometry, int image_width) {
   DisparityImage image(image_width, map.height);
   const auto steps = float(map.steps_per_pixel());
   for (int y = 0; y < map.height; ++y)
      for (int x = 0; x < map.width; ++x)
         if (map.has_value_at(x, y))
            image.at(geometry.first_column + x, y) = float(geometry.min_disparity) + float(map.at(x, y)) / steps;
   return image;
}

}  // namespace stereo::app
