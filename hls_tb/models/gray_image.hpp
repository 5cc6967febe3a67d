// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace stereo {

/// An 8-bit picture in raster order, row 0 first. Disparity maps are pictures too.
struct GrayImage {
   int width = 0;
   int height = 0;
   std::vector<uint8_t> pixels;

   GrayImage() = default;
   GrayImage(int width_px, int height_px, uint8_t value = 0)
       : width(width_px), height(height_px), pixels(std::size_t(width_px) * std::size_t(height_px), value) {}

   uint8_t& at(int x, int y) { return row(y)[x]; }
   uint8_t at(int x, int y) const { return row(y)[x]; }
   uint8_t* row(int y) { return pixels.data() + std::ptrdiff_t(y) * width; }
   const uint8_t* row(int y) const { return pixels.data() + std::ptrdiff_t(y) * width; }

   bool same_size(const GrayImage& other) const { return width == other.width && height == other.height; }
   bool operator==(const GrayImage&) const = default;
};

/// A rectified pair.
struct ImagePair {
   GrayImage left, right;
};

}  // namespace stereo
