// SPDX-License-Identifier: Apache-2.0
#include "program/evaluation/camera_difference.hpp"

#include <algorithm>
#include <cmath>

#include "scene/random.hpp"

namespace stereo::app {
namespace {

/// Nearly normal, of deviation 1: a sum of twelve even ones, the same on every machine.
double normal(Random& random) {
   double sum = -6;
   for (int i = 0; i < 12; ++i) sum += random.between(0, 1);
   return sum;
}

void change(GrayImage& image, double gain, double offset, double noise, uint64_t seed) {
   Random random(seed);
   for (uint8_t& pixel : image.pixels) {
      const double value = gain * pixel + offset + (noise > 0 ? noise * normal(random) : 0);
      pixel = uint8_t(std::clamp(std::lround(value), 0L, 255L));
   }
}

}  // namespace

ImagePair seen_by(const ImagePair& pair, const CameraDifference& difference) {
   ImagePair seen = pair;
   change(seen.left, 1, 0, difference.noise, 2 * uint64_t(difference.seed));
   change(seen.right, difference.gain, difference.offset, difference.noise, 2 * uint64_t(difference.seed) + 1);
   return seen;
}

}  // namespace stereo::app
