// SPDX-License-Identifier: Apache-2.0
#include "dynamic_range/coarse_pixels.hpp"

#include <gtest/gtest.h>

#include "definition/dynamic_range/search_windows.hpp"
#include "dynamic_range/configurations.hpp"
#include "engines/clocked/heap_memories.hpp"
#include "scene/random.hpp"
#include "testing/seed.hpp"
#include "testing/test_pairs.hpp"

namespace stereo::test {
namespace {

ImagePair pair_of(const dynamic_range::Config& c, uint64_t seed, uint8_t) {
   return random_pair(c.width_px, c.height_px, seed);
}
/// Half of them black and white: the largest sums.
DeepPair pair_of(const dynamic_range::Config& c, uint64_t seed, uint16_t) {
   const int levels = seed % 2 == 0 ? 2 : 1 << c.pixel_bits;
   return random_deep_pair(c.width_px, c.height_px, seed, c.pixel_bits, levels);
}

template <const dynamic_range::Config& C>
void expect_means() {
   Random random(test_seed());
   HeapMemories memories;
   dynamic_range::CoarsePixels<C> block(memories, MemoryId<0>());
   const auto some_pair = [](uint64_t seed) { return pair_of(C, seed, Pixel<C>()); };
   using Pair = decltype(some_pair(0));
   std::vector<Pixel<C>> left, right;
   std::vector<std::size_t> starts;
   const auto clock = [&](const CoreInput<C>& in) {
      block.clock(in);
      if (!block.out.valid) return;
      if (block.out.start_of_frame) starts.push_back(left.size());
      left.push_back(block.out.left[0]);
      right.push_back(block.out.right[0]);
   };
   const auto send = [&](const Pair& pair, int pixels) {
      for (int i = 0; i < pixels; ++i) {
         CoreInput<C> in;
         for (in.start_of_frame = true; random.percent(30);) clock(in);  // a bubble: not valid, whatever it says
         in.left[0] = pair.left.pixels[std::size_t(i)];
         in.right[0] = pair.right.pixels[std::size_t(i)];
         in.start_of_frame = i == 0;
         in.valid = true;
         clock(in);
      }
   };
   const int pixels = C.width_px * C.height_px;
   for (int frame = 0; frame < 4; ++frame) {
      const Pair pair = some_pair(test_seed() + uint64_t(frame));
      // Some frames follow one that breaks off.
      if (frame % 2 == 1) send(some_pair(1), random.below(pixels));
      left.clear(), right.clear(), starts.clear();
      send(pair, pixels);
      for (int i = 0; i < block.kClocks + C.coarse_disparities(); ++i) clock(CoreInput<C>());
      // What was on its way when the frame began comes first.
      ASSERT_EQ(starts.size(), 1u);
      left.erase(left.begin(), left.begin() + std::ptrdiff_t(starts[0]));
      right.erase(right.begin(), right.begin() + std::ptrdiff_t(starts[0]));
      EXPECT_EQ(left, dynamic_range::coarse_image(pair.left, C.coarse_disparities()).pixels);
      EXPECT_EQ(right, dynamic_range::coarse_image(pair.right, C.coarse_disparities()).pixels);
   }
}

TEST(CoarsePixels, AreThoseOfTheDefinition) {
   expect_means<dynamic_range::configurations::tiny_dynamic>();
   expect_means<dynamic_range::configurations::tiny_dynamic_10bit>();
   expect_means<dynamic_range::configurations::tiny_dynamic_12bit>();
}

}  // namespace
}  // namespace stereo::test
