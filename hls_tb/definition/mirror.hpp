// SPDX-License-Identifier: Apache-2.0
// Left to right, and back. A left reference is the mirror image of a right one.
#pragma once

#include <algorithm>

#include "definition/disparity_map.hpp"
#include "definition/gray_image.hpp"

namespace stereo {

template <class Pixel>
void mirror_rows(std::vector<Pixel>& pixels, int width) {
   for (auto row = pixels.begin(); row != pixels.end(); row += width) std::reverse(row, row + width);
}

template <class Pixel>
RasterImage<Pixel> mirrored(RasterImage<Pixel> image) {
   mirror_rows(image.pixels, image.width);
   return image;
}

inline DisparityMap mirrored(DisparityMap map) {
   mirror_rows(map.disparity, map.width);
   mirror_rows(map.valid, map.width);
   mirror_rows(map.confidence, map.width);
   mirror_rows(map.filled, map.width);
   return map;
}

/// The pair whose right image is the mirrored left one.
template <class Pixel>
PairOf<Pixel> mirrored(const PairOf<Pixel>& pair) {
   return {mirrored(pair.right), mirrored(pair.left)};
}

}  // namespace stereo
