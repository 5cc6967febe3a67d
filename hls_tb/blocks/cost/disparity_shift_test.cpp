// SPDX-License-Identifier: Apache-2.0
#include "cost/disparity_shift.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "block_matching/config.hpp"
#include "frontend/features.hpp"
#include "frontend/pixel_tag.hpp"
#include "scene/random.hpp"
#include "testing/seed.hpp"
#include "testing/test_configs.hpp"

namespace stereo::test {
namespace {

/// A column of random pixels, or a bubble of them.
template <const block_matching::Config& C>
struct RandomColumn {
   Feature<C> search[C.tap_rows()], reference[C.tap_rows()];
   PixelTag tag;

   explicit RandomColumn(Random& random) {
      tag.valid = !random.percent(25);
      tag.output_column = random.percent(50);
      for (Feature<C>& pixel : search) pixel = random.byte();
      for (Feature<C>& pixel : reference) pixel = random.byte();
   }
};

/// The searched pixels of each tap, oldest first.
template <const block_matching::Config& C, int Zeros>
struct History {
   std::vector<Feature<C>> rows[C.tap_rows()];

   History() {
      for (auto& row : rows) row.assign(Zeros, 0);  // reset: zeros came before
   }
   void push(const RandomColumn<C>& column) {
      for (int t = 0; t < C.tap_rows(); ++t) rows[t].push_back(column.search[t]);
   }
   /// The pixel of tap t that came `age` records before the newest.
   Feature<C> before(int t, int age) const { return rows[t][rows[t].size() - 1 - std::size_t(age)]; }
};

/// A right pixel is compared with left ones at and to the right of it, the newest at the highest disparity; a left
/// pixel with right ones at and to the left of it, the newest at the lowest.
template <const block_matching::Config& C>
int age(int count, int i) {
   return C.reference == Reference::right ? count - 1 - i : i;
}

template <class Config>
class DisparityShiftTest : public ::testing::Test {};
TYPED_TEST_SUITE(DisparityShiftTest, SmallConfigs, ConfigNames);

TYPED_TEST(DisparityShiftTest, HoldsTheLastPixels) {
   static constexpr block_matching::Config C = TypeParam::kConfig;
   constexpr int kCount = C.largest_slice();
   Random random(test_seed());
   DisparityShift<C, kCount> shift;
   History<C, kCount + 1> searched;
   for (int clock = 0; clock < 3 * kCount + 50; ++clock) {
      const RandomColumn<C> in(random);
      shift.clock(in.search, in.reference, in.tag);
      ASSERT_EQ(shift.tag.valid, in.tag.valid);
      ASSERT_EQ(shift.tag.output_column, in.tag.output_column);
      if (!in.tag.valid) continue;
      searched.push(in);
      for (int t = 0; t < C.tap_rows(); ++t) {
         ASSERT_EQ(shift.reference[t], in.reference[t]) << "clock " << clock << " t=" << t;
         ASSERT_EQ(shift.search_out[t], searched.before(t, kCount)) << "clock " << clock << " t=" << t;
         for (int i = 0; i < kCount; ++i)
            ASSERT_EQ(shift.search[t][i], searched.before(t, age<C>(kCount, i)))
                << "clock " << clock << " t=" << t << " i=" << i;
      }
   }
}

/// The second of two shifts holds what one long shift would hold behind the first, one clock later.
TYPED_TEST(DisparityShiftTest, ContinuesInTheNextShift) {
   static constexpr block_matching::Config C = TypeParam::kConfig;
   constexpr int kFirst = 3, kSecond = 2;
   Random random(test_seed());
   DisparityShift<C, kFirst> first;
   DisparityShift<C, kSecond> second;
   History<C, kFirst + kSecond> searched;
   RandomColumn<C> before(random);
   before.tag.valid = false;
   for (int clock = 0; clock < 100; ++clock) {
      const RandomColumn<C> in(random);
      second.clock(first.search_out, first.reference, first.tag);
      first.clock(in.search, in.reference, in.tag);
      ASSERT_EQ(second.tag.valid, before.tag.valid);
      if (before.tag.valid) {
         searched.push(before);
         for (int t = 0; t < C.tap_rows(); ++t) {
            ASSERT_EQ(second.reference[t], before.reference[t]) << "clock " << clock << " t=" << t;
            for (int i = 0; i < kSecond; ++i)
               ASSERT_EQ(second.search[t][i], searched.before(t, kFirst + age<C>(kSecond, i)))
                   << "clock " << clock << " t=" << t << " i=" << i;
         }
      }
      before = in;
   }
}

}  // namespace
}  // namespace stereo::test
