// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "definition/gray_image.hpp"

namespace stereo::test {

struct NamedPair {
   std::string name;
   ImagePair images;
};

/// Both images random, of `levels` grey values: few levels give many ties.
ImagePair random_pair(int width, int height, uint64_t seed, int levels = 256);

/// Both images random, of `levels` grey values of 0 ... 2^bits - 1.
DeepPair random_deep_pair(int width, int height, uint64_t seed, int bits, int levels);

/// left(x + disparity, y) = right(x, y), random elsewhere.
ImagePair shifted_pair(int width, int height, int disparity, uint64_t seed);

/// Flat, saturated, periodic, random, shifted and scene pairs of a size.
std::vector<NamedPair> test_pairs(int width, int height, int disparities, uint64_t seed);

}  // namespace stereo::test
