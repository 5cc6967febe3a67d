// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "definition/gray_image.hpp"

namespace stereo::app {

/// How the right camera differs from the left one, and how noisy both are.
struct CameraDifference {
   double gain = 1, offset = 0;  ///< the right image is gain * grey value + offset
   double noise = 0;             ///< standard deviation in grey levels, added to both images
   int seed = 1;                 ///< of the noise

   bool operator==(const CameraDifference&) const = default;
};

/// The pair as such cameras see it: rounded and clamped to 0 ... 2^bits - 1.
template <class Pixel>
PairOf<Pixel> seen_by(const PairOf<Pixel>& pair, const CameraDifference& difference, int bits = 8);

}  // namespace stereo::app
