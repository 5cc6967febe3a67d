// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace stereo {

/// A picture in raster order, row 0 first.
template <class Pixel>
struct RasterImage {
   int width = 0;
   int height = 0;
   std::vector<Pixel> pixels;

   RasterImage() = default;
   RasterImage(int width_px, int height_px, Pixel value = 0)
       : width(width_px), height(height_px), pixels(std::size_t(width_px) * std::size_t(height_px), value) {}

   Pixel& at(int x, int y) { return row(y)[x]; }
   Pixel at(int x, int y) const { return row(y)[x]; }
   Pixel* row(int y) { return pixels.data() + std::ptrdiff_t(y) * width; }
   const Pixel* row(int y) const { return pixels.data() + std::ptrdiff_t(y) * width; }

   bool same_size(const RasterImage& other) const { return width == other.width && height == other.height; }
   bool operator==(const RasterImage&) const = default;
};

/// Grey values of 8 bits; masks, too.
using GrayImage = RasterImage<uint8_t>;
/// Grey values of more bits.
using DeepImage = RasterImage<uint16_t>;

/// A rectified pair.
template <class Pixel>
struct PairOf {
   RasterImage<Pixel> left, right;
};
using ImagePair = PairOf<uint8_t>;
using DeepPair = PairOf<uint16_t>;

/// The same grey values.
inline DeepImage widened(const GrayImage& image) {
   DeepImage wide(image.width, image.height);
   wide.pixels.assign(image.pixels.begin(), image.pixels.end());
   return wide;
}

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
