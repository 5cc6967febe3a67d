// SPDX-License-Identifier: Apache-2.0
#include "memory_bank.hpp"

#include <gtest/gtest.h>

#include <array>
#include <set>
#include <vector>

#include "models/random.hpp"
#include "stereo_core.hpp"
#include "support/seed.hpp"

namespace stereo::test {
namespace {

/// Gives zeros and keeps the numbers that were asked for, and the memories' sizes.
struct NumberedMemories {
   std::vector<int> numbers;

   template <class Word, int Depth, int Number>
   Word (&words())[Depth] {
      static Word memory[Depth];
      fill<Word>(memory, 0);
      numbers.push_back(Number);
      return memory;
   }
};

constexpr int kDepth = 7, kCount = 3;
using Bank = MemoryBank<uint16_t, kDepth, kCount>;
using Model = std::array<std::array<uint16_t, kDepth>, kCount>;

TEST(MemoryBank, TakesItsNumbersInTurn) {
   NumberedMemories memories;
   const Bank bank(memories, MemoryId<40>());
   EXPECT_EQ(std::set<int>(memories.numbers.begin(), memories.numbers.end()), (std::set<int>{40, 41, 42}));
   EXPECT_EQ(memories.numbers.size(), 3u);
}

TEST(MemoryBank, ReadsTogetherOrEachAtItsAddressWhatWasWritten) {
   Random random(test_seed());
   NumberedMemories memories;
   Bank bank(memories, MemoryId<0>());
   Model model{};
   for (int round = 0; round < 1000; ++round) {
      const uint16_t address = uint16_t(random.below(kDepth));
      uint16_t in[kCount], out[kCount], addresses[kCount];
      for (std::size_t i = 0; i < kCount; ++i) {
         in[i] = uint16_t(random.bits());
         model[i][address] = in[i];
         addresses[i] = uint16_t(random.below(kDepth));
      }
      bank.write(address, in);
      bank.read(addresses[0], out);
      for (std::size_t i = 0; i < kCount; ++i) ASSERT_EQ(out[i], model[i][addresses[0]]) << "memory " << i;
      bank.read_each(addresses, out);
      for (std::size_t i = 0; i < kCount; ++i) ASSERT_EQ(out[i], model[i][addresses[i]]) << "memory " << i;
   }
}

/// One memory for two banks would be a fault that small images need not show.
template <const StereoConfig& C>
void no_number_serves_twice() {
   NumberedMemories memories;
   const auto core = std::make_unique<StereoCore<C>>(memories);
   const std::set<int> numbers(memories.numbers.begin(), memories.numbers.end());
   EXPECT_EQ(numbers.size(), memories.numbers.size());
   EXPECT_GT(numbers.size(), 1u);
}

/// Every bank there is, as large as they get: 31x31 windows, 256 disparities in one slice, four rows at once.
inline constexpr StereoConfig kLargest{.width_px = 400,
                                       .height_px = 40,
                                       .disparities = 256,
                                       .window_px = 31,
                                       .pixels_per_clock = 4,
                                       .prefilter = Prefilter::xsobel,
                                       .left_right_threshold = 1,
                                       .texture_threshold = 1,
                                       .subpixel = true,
                                       .median = true,
                                       .aggregation = Aggregation::recursive,
                                       .slice_disparities = 256};
/// The same in the smallest slices.
inline constexpr StereoConfig kMostSlices{.width_px = 400,
                                          .height_px = 40,
                                          .disparities = 24,
                                          .window_px = 31,
                                          .pixels_per_clock = 4,
                                          .aggregation = Aggregation::recursive,
                                          .slice_disparities = 2};
/// The widest words: 62 bits of census in each of 31 stored rows.
inline constexpr StereoConfig kWidest{.width_px = 40,
                                      .height_px = 36,
                                      .disparities = 16,
                                      .window_px = 31,
                                      .pixels_per_clock = 4,
                                      .min_disparity = 3,
                                      .cost = Cost::census,
                                      .census_width_px = 9,
                                      .census_height_px = 7,
                                      .left_right_threshold = 1,
                                      .median = true,
                                      .slice_disparities = 16};

TEST(MemoryBank, NoNumberServesTwoMemoriesOfACore) {
   no_number_serves_twice<configurations::tiny_all_recursive>();
   no_number_serves_twice<kLargest>();
   no_number_serves_twice<kMostSlices>();
   no_number_serves_twice<kWidest>();
}

}  // namespace
}  // namespace stereo::test
