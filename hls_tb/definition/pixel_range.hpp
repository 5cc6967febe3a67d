// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <string>

#include "definition/gray_image.hpp"

namespace stereo {

/// Which pixel is not 0 ... 2^bits - 1, for a sentence that begins with the name of the image; empty when all are.
template <class Pixel>
std::string beyond_range(const RasterImage<Pixel>& image, int bits) {
   const auto found = std::ranges::find_if(image.pixels, [bits](Pixel pixel) { return pixel >> bits != 0; });
   if (found == image.pixels.end()) return "";
   const auto place = found - image.pixels.begin();
   return "has the grey value " + std::to_string(*found) + " at x=" + std::to_string(place % image.width) +
          " y=" + std::to_string(place / image.width) + " but pixels of " + std::to_string(bits) +
          " bits are at most " + std::to_string((1 << bits) - 1);
}

/// What 8 bits can show of grey values of `bits` bits.
inline GrayImage upper_8_bits(const DeepImage& image, int bits) {
   GrayImage result(image.width, image.height);
   std::ranges::transform(image.pixels, result.pixels.begin(),
                          [bits](uint16_t pixel) { return uint8_t(pixel >> (bits - 8)); });
   return result;
}

}  // namespace stereo
