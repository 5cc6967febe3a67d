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

template <class Pixel>
void change(RasterImage<Pixel>& image, int bits, double gain, double offset, double noise, uint64_t seed) {
   const long largest = (1L << bits) - 1;
   Random random(seed);
   for (Pixel& pixel : image.pixels) {
      const double value = gain * pixel + offset + (noise > 0 ? noise * normal(random) : 0);
      pixel = Pixel(std::clamp(std::lround(value), 0L, largest));
   }
}

}  // namespace

template <class Pixel>
PairOf<Pixel> seen_by(const PairOf<Pixel>& pair, const CameraDifference& difference, int bits) {
   PairOf<Pixel> seen = pair;
   change(seen.left, bits, 1, 0, difference.noise, 2 * uint64_t(difference.seed));
   change(seen.right, bits, difference.gain, difference.offset, difference.noise, 2 * uint64_t(difference.seed) + 1);
   return seen;
}
template ImagePair seen_by(const ImagePair&, const CameraDifference&, int);
template DeepPair seen_by(const DeepPair&, const CameraDifference&, int);

}  // namespace stereo::app
