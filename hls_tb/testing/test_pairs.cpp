// SPDX-License-Identifier: Apache-2.0
#include "testing/test_pairs.hpp"

#include "scene/random.hpp"
#include "scene/scene.hpp"

namespace stereo::test {
namespace {

template <class Value>
GrayImage image_of(int width, int height, Value value) {
   GrayImage image(width, height);
   for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) image.at(x, y) = uint8_t(value(x, y));
   return image;
}

}  // namespace

ImagePair random_pair(int width, int height, uint64_t seed, int levels) {
   Random random(seed);
   const auto value = [&](int, int) { return random.below(levels) * 255 / (levels - 1); };
   GrayImage left = image_of(width, height, value);
   return {std::move(left), image_of(width, height, value)};
}

DeepPair random_deep_pair(int width, int height, uint64_t seed, int bits, int levels) {
   Random random(seed);
   DeepPair pair{DeepImage(width, height), DeepImage(width, height)};
   for (DeepImage* image : {&pair.left, &pair.right})
      for (uint16_t& pixel : image->pixels)
         pixel = uint16_t(int64_t(random.below(levels)) * ((1 << bits) - 1) / (levels - 1));
   return pair;
}

ImagePair shifted_pair(int width, int height, int disparity, uint64_t seed) {
   ImagePair pair = random_pair(width, height, seed);
   for (int y = 0; y < height; ++y)
      for (int x = 0; x + disparity < width; ++x) pair.left.at(x + disparity, y) = pair.right.at(x, y);
   return pair;
}

std::vector<NamedPair> test_pairs(int width, int height, int disparities, uint64_t seed) {
   const GrayImage black(width, height, 0), grey(width, height, 119), white(width, height, 255);
   const GrayImage stripes = image_of(width, height, [](int x, int) { return x % 3 * 80; });
   const GrayImage checkers = image_of(width, height, [](int x, int y) { return (x + y) % 2 * 255; });
   const GrayImage inverse = image_of(width, height, [](int x, int y) { return (x + y + 1) % 2 * 255; });
   const SceneOptions scene{.width = width, .height = height, .disparities = disparities, .seed = seed};
   return {{"flat", {grey, grey}},
           {"left white, right black", {white, black}},
           {"left black, right white", {black, white}},
           {"periodic", {stripes, stripes}},
           {"periodic and saturated", {checkers, inverse}},
           {"random", random_pair(width, height, seed)},
           {"two grey values", random_pair(width, height, seed, 2)},
           {"four grey values", random_pair(width, height, seed, 4)},
           {"shifted by 1", shifted_pair(width, height, 1, seed)},
           {"shifted by the largest disparity", shifted_pair(width, height, disparities - 1, seed)},
           {"scene", make_scene(scene).images}};
}

}  // namespace stereo::test
