// SPDX-License-Identifier: Apache-2.0
#include "line_buffer.hpp"

#include <gtest/gtest.h>

#include <deque>

#include "models/random.hpp"
#include "support/seed.hpp"
#include "support/test_configs.hpp"

namespace stereo::test {
namespace {

template <class Config>
class LineBufferTest : public ::testing::Test {};
TYPED_TEST_SUITE(LineBufferTest, SmallConfigs);

struct Column {
   bool valid = false;
   std::vector<int> left, right;
};

template <const StereoConfig& C>
void gives_columns_of_the_rows_above() {
   constexpr int W = C.width_px, B = C.window_px;
   Random random(test_seed());
   typename ReferenceDelay<C>::Memory reference_memory{};
   typename LineBuffer<C>::Memory memory{};
   ReferenceDelay<C> in(reference_memory);
   LineBuffer<C> rows(memory);
   std::vector<uint8_t> lefts, rights;
   std::deque<Column> pipeline(1);  // what comes out one clock after it went in
   for (int n = 0; n < W * (3 * B + 2);) {
      in.tag = {};
      in.tag.valid = !random.percent(25);
      in.tag.cost_column = random.percent(50);
      in.left = random.byte();
      in.right = random.byte();
      in.column = uint16_t(n % W);
      for (int k = 0; k < B; ++k) in.row_inside[k] = random.percent(70) && n >= k * W;
      Column expected{in.tag.valid, {}, {}};
      if (in.tag.valid) {
         lefts.push_back(in.left);
         rights.push_back(in.right);
         for (int k = 0; k < B; ++k) {
            const auto place = std::size_t(n - k * W);
            expected.left.push_back(in.row_inside[k] ? lefts[place] : 0);
            expected.right.push_back(in.row_inside[k] ? rights[place] : 0);
         }
         ++n;
      }
      pipeline.push_back(expected);
      rows.clock(in);
      const Column now = pipeline.front();
      pipeline.pop_front();
      ASSERT_EQ(rows.tag.valid, now.valid) << "pair " << n;
      for (std::size_t k = 0; k < now.left.size(); ++k) {
         ASSERT_EQ(rows.left[k], now.left[k]) << "pair " << n << " row above " << k;
         ASSERT_EQ(rows.right[k], now.right[k]) << "pair " << n << " row above " << k;
      }
   }
}

TYPED_TEST(LineBufferTest, GivesColumnsOfTheRowsAbove) { gives_columns_of_the_rows_above<TypeParam::kConfig>(); }

}  // namespace
}  // namespace stereo::test
