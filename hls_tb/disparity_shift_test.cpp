// SPDX-License-Identifier: Apache-2.0
#include "disparity_shift.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "models/random.hpp"
#include "support/seed.hpp"
#include "support/test_configs.hpp"

namespace stereo::test {
namespace {

/// A column of random pixels, or a bubble of them.
template <const StereoConfig& C>
struct RandomColumn {
   uint8_t left[C.tap_rows()], right[C.tap_rows()];
   PixelTag tag;

   explicit RandomColumn(Random& random) {
      tag.valid = !random.percent(25);
      tag.output_column = random.percent(50);
      for (uint8_t& pixel : left) pixel = random.byte();
      for (uint8_t& pixel : right) pixel = random.byte();
   }
};

/// The left pixels of each tap, oldest first.
template <const StereoConfig& C, int Zeros>
struct History {
   std::vector<uint8_t> rows[C.tap_rows()];

   History() {
      for (auto& row : rows) row.assign(Zeros, 0);  // reset: zeros came before
   }
   void push(const RandomColumn<C>& column) {
      for (int t = 0; t < C.tap_rows(); ++t) rows[t].push_back(column.left[t]);
   }
   /// The pixel of tap t that came `age` records before the newest.
   uint8_t before(int t, int age) const { return rows[t][rows[t].size() - 1 - std::size_t(age)]; }
};

template <class Config>
class DisparityShiftTest : public ::testing::Test {};
TYPED_TEST_SUITE(DisparityShiftTest, SmallConfigs, ConfigNames);

TYPED_TEST(DisparityShiftTest, HoldsTheLastPixelsOldestFirst) {
   static constexpr StereoConfig C = TypeParam::kConfig;
   constexpr int kCount = C.largest_slice();
   Random random(test_seed());
   DisparityShift<C, kCount> shift;
   History<C, kCount + 1> lefts;
   for (int clock = 0; clock < 3 * kCount + 50; ++clock) {
      const RandomColumn<C> in(random);
      shift.clock(in.left, in.right, in.tag);
      ASSERT_EQ(shift.tag.valid, in.tag.valid);
      ASSERT_EQ(shift.tag.output_column, in.tag.output_column);
      if (!in.tag.valid) continue;
      lefts.push(in);
      for (int t = 0; t < C.tap_rows(); ++t) {
         ASSERT_EQ(shift.right[t], in.right[t]) << "clock " << clock << " t=" << t;
         ASSERT_EQ(shift.left_out[t], lefts.before(t, kCount)) << "clock " << clock << " t=" << t;
         for (int i = 0; i < kCount; ++i)
            ASSERT_EQ(shift.left[t][i], lefts.before(t, kCount - 1 - i))
                << "clock " << clock << " t=" << t << " i=" << i;
      }
   }
}

/// The second of two shifts holds what one long shift would hold below the first, one clock later.
TYPED_TEST(DisparityShiftTest, ContinuesInTheNextShift) {
   static constexpr StereoConfig C = TypeParam::kConfig;
   constexpr int kFirst = 3, kSecond = 2;
   Random random(test_seed());
   DisparityShift<C, kFirst> first;
   DisparityShift<C, kSecond> second;
   History<C, kFirst + kSecond> lefts;
   RandomColumn<C> before(random);
   before.tag.valid = false;
   for (int clock = 0; clock < 100; ++clock) {
      const RandomColumn<C> in(random);
      second.clock(first.left_out, first.right, first.tag);
      first.clock(in.left, in.right, in.tag);
      ASSERT_EQ(second.tag.valid, before.tag.valid);
      if (before.tag.valid) {
         lefts.push(before);
         for (int t = 0; t < C.tap_rows(); ++t) {
            ASSERT_EQ(second.right[t], before.right[t]) << "clock " << clock << " t=" << t;
            for (int i = 0; i < kSecond; ++i)
               ASSERT_EQ(second.left[t][i], lefts.before(t, kFirst + kSecond - 1 - i))
                   << "clock " << clock << " t=" << t << " i=" << i;
         }
      }
      before = in;
   }
}

}  // namespace
}  // namespace stereo::test
