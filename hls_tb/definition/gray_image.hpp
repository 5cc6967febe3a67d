// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace stereo {

/// An 8-bit picture in raster order, row 0 first.
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

/// As sentences show a size: "320x240".
inline std::string size_text(int width, int height) { return std::to_string(width) + "x" + std::to_string(height); }

/// Image: anything with a width and a height.
template <class Image>
std::string size_text(const Image& image) {
   return size_text(image.width, image.height);
}

/// Throws Error with one sentence unless the sizes are the same. `left_name`, `right_name`: what it calls the images.
template <class Error, class Image>
void require_same_size(const std::string& left_name, const Image& left, const std::string& right_name,
                       const Image& right) {
   if (left.width != right.width || left.height != right.height)
      throw Error("the images differ in size: " + left_name + " is " + size_text(left) + ", " + right_name + " is " +
                  size_text(right) + "; give a pair of one size");
}

}  // namespace stereo
