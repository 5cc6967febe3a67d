// SPDX-License-Identifier: Apache-2.0
#include "line_buffer.hpp"

#include <gtest/gtest.h>

#include <array>
#include <deque>
#include <vector>

#include "models/random.hpp"
#include "support/seed.hpp"
#include "support/test_configs.hpp"

namespace stereo::test {
namespace {

template <class Config>
class LineBufferTest : public ::testing::Test {};
TYPED_TEST_SUITE(LineBufferTest, SmallConfigs, ConfigNames);

struct Column {
   bool valid = false;
   std::vector<int> left, right;  ///< of all rows that the windows cover, top row first; empty for a bubble
};

/// The image as a list of rows, as far as it has come.
template <const StereoConfig& C>
struct Rows {
   std::vector<std::array<uint8_t, C.width_px>> rows;

   void set(int x, int y, uint8_t value) {
      if (std::size_t(y) >= rows.size()) rows.resize(std::size_t(y) + 1);
      rows[std::size_t(y)][std::size_t(x)] = value;
   }
   uint8_t at(int x, int y) const { return rows.at(std::size_t(y))[std::size_t(x)]; }
};

TYPED_TEST(LineBufferTest, GivesColumnsOfAllRowsThatTheWindowsCover) {
   static constexpr StereoConfig C = TypeParam::kConfig;
   constexpr int W = C.width_px, P = C.pixels_per_clock, kTaps = C.tap_rows(), kClocks = 3;
   Random random(test_seed());
   typename ReferenceDelay<C>::Memory reference_memory{};
   typename LineBuffer<C>::Memory left_memory{}, right_memory{};
   ReferenceDelay<C> in(reference_memory);
   LineBuffer<C> rows(left_memory, right_memory);
   Rows<C> lefts, rights;
   std::deque<Column> pipeline(kClocks - 1);  // what has gone in and not yet come out
   for (int n = 0; n < W * (3 * kTaps + 2);) {
      in.tag = {};
      in.tag.valid = !random.percent(25);
      // A bubble's column means nothing, nor do its pixels.
      const int x = in.tag.valid ? n % W : random.below(W), group = n / W;
      in.column = uint16_t(x);
      in.right = uint_of_bits<8 * P>(random.bits());
      Column expected{in.tag.valid, {}, {}};
      for (int p = 0; p < P; ++p) {
         in.left[p] = random.byte();
         if (!in.tag.valid) continue;
         lefts.set(x, group * P + p, in.left[p]);
         rights.set(x, group * P + p, uint8_t(in.right >> (8 * p)));
      }
      for (int t = 0; t < kTaps; ++t) {
         const int y = (group - C.delay_groups()) * P - C.radius_px() + t;
         in.row_inside[t] = random.percent(70) && y >= 0;
         if (!in.tag.valid) continue;
         expected.left.push_back(in.row_inside[t] ? lefts.at(x, y) : 0);
         expected.right.push_back(in.row_inside[t] ? rights.at(x, y) : 0);
      }
      n += in.tag.valid ? 1 : 0;
      pipeline.push_back(expected);
      rows.clock(in);
      const Column now = pipeline.front();
      pipeline.pop_front();
      ASSERT_EQ(rows.tag.valid, now.valid) << "record " << n;
      for (std::size_t t = 0; t < now.left.size(); ++t) {
         ASSERT_EQ(rows.left[t], now.left[t]) << "record " << n << " t=" << t;
         ASSERT_EQ(rows.right[t], now.right[t]) << "record " << n << " t=" << t;
      }
   }
}

TYPED_TEST(LineBufferTest, PassesTheTagOn) {
   static constexpr StereoConfig C = TypeParam::kConfig;
   Random random(test_seed());
   typename ReferenceDelay<C>::Memory reference_memory{};
   typename LineBuffer<C>::Memory left_memory{}, right_memory{};
   ReferenceDelay<C> in(reference_memory);
   LineBuffer<C> rows(left_memory, right_memory);
   std::deque<PixelTag> pipeline(2);
   for (int i = 0; i < 200; ++i) {
      in.tag = {.valid = random.percent(75),
                .border_column = random.percent(50),
                .output_column = random.percent(50),
                .start_of_frame = random.percent(50),
                .end_of_line = random.percent(50)};
      pipeline.push_back(in.tag);
      rows.clock(in);
      const PixelTag now = pipeline.front();
      pipeline.pop_front();
      ASSERT_EQ(rows.tag.valid, now.valid);
      ASSERT_EQ(rows.tag.border_column, now.border_column);
      ASSERT_EQ(rows.tag.output_column, now.output_column);
      ASSERT_EQ(rows.tag.start_of_frame, now.start_of_frame);
      ASSERT_EQ(rows.tag.end_of_line, now.end_of_line);
   }
}

}  // namespace
}  // namespace stereo::test
