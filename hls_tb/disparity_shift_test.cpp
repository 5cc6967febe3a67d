// SPDX-License-Identifier: Apache-2.0
#include "disparity_shift.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "models/random.hpp"
#include "support/seed.hpp"
#include "support/test_configs.hpp"

namespace stereo::test {
namespace {

template <class Config>
class DisparityShiftTest : public ::testing::Test {};
TYPED_TEST_SUITE(DisparityShiftTest, SmallConfigs);

template <const StereoConfig& C>
void holds_the_last_pixels_oldest_first() {
   constexpr int D = C.disparities, B = C.window_px;
   Random random(test_seed());
   typename LineBuffer<C>::Memory unused_rows{};
   LineBuffer<C> rows(unused_rows);
   DisparityShift<C> shift;
   std::vector<std::vector<uint8_t>> lefts(B, std::vector<uint8_t>(D, 0));  // reset: zeros came before
   for (int clock = 0; clock < 3 * D + 50; ++clock) {
      rows.tag.valid = !random.percent(25);
      for (int k = 0; k < B; ++k) {
         rows.left[k] = random.byte();
         rows.right[k] = random.byte();
         if (rows.tag.valid) lefts[std::size_t(k)].push_back(rows.left[k]);
      }
      shift.clock(rows);
      ASSERT_EQ(shift.tag.valid, rows.tag.valid);
      if (!rows.tag.valid) continue;
      for (int k = 0; k < B; ++k) {
         const std::vector<uint8_t>& row = lefts[std::size_t(k)];
         ASSERT_EQ(shift.right[k], rows.right[k]) << "clock " << clock << " row above " << k;
         for (int d = 0; d < D; ++d)
            ASSERT_EQ(shift.left[k][d], row[row.size() - std::size_t(D - d)])
                << "clock " << clock << " row above " << k << " d=" << d;
      }
   }
}

TYPED_TEST(DisparityShiftTest, HoldsTheLastPixelsOldestFirst) {
   holds_the_last_pixels_oldest_first<TypeParam::kConfig>();
}

}  // namespace
}  // namespace stereo::test
