// SPDX-License-Identifier: Apache-2.0
#include "frontend/line_buffer.hpp"

#include <gtest/gtest.h>

#include <array>
#include <deque>
#include <vector>

#include "block_matching/config.hpp"
#include "engines/clocked/heap_memories.hpp"
#include "frontend/features.hpp"
#include "frontend/pair_delay.hpp"
#include "frontend/pixel_tag.hpp"
#include "scene/random.hpp"
#include "support/memory_bank.hpp"
#include "testing/seed.hpp"
#include "testing/tags.hpp"
#include "testing/test_configs.hpp"

namespace stereo::test {
namespace {

template <class Config>
class LineBufferTest : public ::testing::Test {};
TYPED_TEST_SUITE(LineBufferTest, AllSmallConfigs, ConfigNames);

struct Column {
   bool valid = false;
   std::vector<int> search, reference;  ///< of all taps; empty for a bubble
   std::vector<bool> inside;
};

/// The image as a list of rows, as far as it has come.
template <const block_matching::Config& C>
struct Rows {
   std::vector<std::array<uint8_t, C.width_px>> rows;

   void set(int x, int y, uint8_t value) {
      if (std::size_t(y) >= rows.size()) rows.resize(std::size_t(y) + 1);
      rows[std::size_t(y)][std::size_t(x)] = value;
   }
   uint8_t at(int x, int y) const { return rows.at(std::size_t(y))[std::size_t(x)]; }
};

/// Sets what the block reads of the block before it.
template <const block_matching::Config& C>
void set_pixels(PairDelay<C>& in, const Feature<C> (&search)[C.pixels_per_clock],
                const Feature<C> (&reference)[C.pixels_per_clock]) {
   using Delay = PairDelay<C>;
   for (int p = 0; p < C.pixels_per_clock; ++p) in.ahead[p] = Delay::kDelaysReference ? search[p] : reference[p];
   Delay::Pack::pack(Delay::kDelaysReference ? reference : search, in.delayed);
}

TYPED_TEST(LineBufferTest, GivesColumnsOfAllRowsThatAreCompared) {
   static constexpr block_matching::Config C = TypeParam::kConfig;
   constexpr int W = C.width_px, P = C.pixels_per_clock, kClocks = 3;
   const std::vector<int> taps = tap_offsets(C);
   Random random(test_seed());
   HeapMemories memories;
   PairDelay<C> in(memories, MemoryId<0>());
   LineBuffer<C> rows(memories, MemoryId<PairDelay<C>::kMemories>());
   Rows<C> searched, references;
   std::deque<Column> pipeline(kClocks - 1);  // what has gone in and not yet come out
   for (int n = 0; n < W * 3 * (C.window_px + P + 2);) {
      in.tag = {};
      in.tag.valid = !random.percent(25);
      // A bubble's column means nothing, nor do its pixels.
      const int x = in.tag.valid ? n % W : random.below(W), group = n / W;
      in.column = uint16_t(x);
      Column expected{in.tag.valid, {}, {}, {}};
      Feature<C> search[P], reference[P];
      for (int p = 0; p < P; ++p) {
         search[p] = random.byte();
         reference[p] = random.byte();
         if (!in.tag.valid) continue;
         searched.set(x, group * P + p, search[p]);
         references.set(x, group * P + p, reference[p]);
      }
      set_pixels<C>(in, search, reference);
      for (std::size_t t = 0; t < taps.size(); ++t) {
         const int y = (group - C.delay_groups()) * P + taps[t];
         const bool inside = random.percent(70) && y >= 0;
         in.row_inside[t] = inside;
         if (!in.tag.valid) continue;
         expected.search.push_back(inside ? searched.at(x, y) : 0);
         expected.reference.push_back(inside ? references.at(x, y) : 0);
         expected.inside.push_back(inside);
      }
      n += in.tag.valid ? 1 : 0;
      pipeline.push_back(expected);
      rows.clock(in);
      const Column now = pipeline.front();
      pipeline.pop_front();
      ASSERT_EQ(rows.tag.valid, now.valid) << "record " << n;
      for (std::size_t t = 0; t < now.search.size(); ++t) {
         ASSERT_EQ(rows.search[t], now.search[t]) << "record " << n << " t=" << t;
         ASSERT_EQ(rows.reference[t], now.reference[t]) << "record " << n << " t=" << t;
         ASSERT_EQ(rows.inside[t], now.inside[t]) << "record " << n << " t=" << t;
      }
   }
}

TYPED_TEST(LineBufferTest, PassesTheTagOn) {
   static constexpr block_matching::Config C = TypeParam::kConfig;
   Random random(test_seed());
   HeapMemories memories;
   PairDelay<C> in(memories, MemoryId<0>());
   LineBuffer<C> rows(memories, MemoryId<PairDelay<C>::kMemories>());
   std::deque<PixelTag> pipeline(2);
   for (int i = 0; i < 200; ++i) {
      in.tag = random_tag(random);
      pipeline.push_back(in.tag);
      rows.clock(in);
      ASSERT_EQ(rows.tag, pipeline.front()) << "clock " << i;
      pipeline.pop_front();
   }
}

}  // namespace
}  // namespace stereo::test
