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

constexpr const auto& C = dynamic_range::configurations::tiny_dynamic;

TEST(CoarsePixels, AreThoseOfTheDefinition) {
   Random random(test_seed());
   HeapMemories memories;
   dynamic_range::CoarsePixels<C> block(memories, MemoryId<0>());
   std::vector<uint8_t> left, right;
   std::vector<std::size_t> starts;
   const auto clock = [&](const StereoInput& in) {
      block.clock(in);
      if (!block.out.valid) return;
      if (block.out.start_of_frame) starts.push_back(left.size());
      left.push_back(block.out.left[0]);
      right.push_back(block.out.right[0]);
   };
   const auto send = [&](const ImagePair& pair, int pixels) {
      for (int i = 0; i < pixels; ++i) {
         StereoInput in;
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
      const ImagePair pair = random_pair(C.width_px, C.height_px, test_seed() + uint64_t(frame));
      // Some frames follow one that breaks off.
      if (frame % 2 == 1) send(random_pair(C.width_px, C.height_px, 1), random.below(pixels));
      left.clear(), right.clear(), starts.clear();
      send(pair, pixels);
      for (int i = 0; i < block.kClocks + C.coarse_disparities(); ++i) clock(StereoInput());
      // What was on its way when the frame began comes first.
      ASSERT_EQ(starts.size(), 1u);
      left.erase(left.begin(), left.begin() + std::ptrdiff_t(starts[0]));
      right.erase(right.begin(), right.begin() + std::ptrdiff_t(starts[0]));
      EXPECT_EQ(left, dynamic_range::coarse_image(pair.left, C.coarse_disparities()).pixels);
      EXPECT_EQ(right, dynamic_range::coarse_image(pair.right, C.coarse_disparities()).pixels);
   }
}

}  // namespace
}  // namespace stereo::test
