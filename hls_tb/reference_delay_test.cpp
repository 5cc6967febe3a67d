// SPDX-License-Identifier: Apache-2.0
#include "reference_delay.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "models/random.hpp"
#include "support/seed.hpp"
#include "support/test_configs.hpp"

namespace stereo::test {
namespace {

template <class Config>
class ReferenceDelayTest : public ::testing::Test {};
TYPED_TEST_SUITE(ReferenceDelayTest, SmallConfigs);

template <const StereoConfig& C>
void delays_the_right_image_and_tags_the_place() {
   constexpr int W = C.width_px, H = C.height_px, D = C.disparities, r = C.radius_px();
   Random random(test_seed());
   typename ReferenceDelay<C>::Memory memory{};
   ReferenceDelay<C> delay(memory);
   Raster<C> raster;
   std::vector<uint8_t> rights;
   for (int n = 0; n < W * (H + r + 1);) {
      const bool valid = !random.percent(25);
      const int x = n % W, y = std::min(n / W, H + r);
      raster.left = random.byte();
      raster.right = random.byte();
      raster.valid = valid;
      raster.column = uint16_t(x);
      raster.row = uint16_t(y);
      delay.clock(raster);
      ASSERT_EQ(delay.tag.valid, valid);
      if (!valid) continue;
      rights.push_back(raster.right);
      ++n;
      if (n >= D) {
         ASSERT_EQ(delay.right, rights[std::size_t(n - D)]) << "x=" << x << " y=" << y;
      }
      ASSERT_EQ(delay.left, raster.left);
      ASSERT_EQ(delay.column, x);
      for (int k = 0; k < C.window_px; ++k)
         ASSERT_EQ(delay.row_inside[k], y - k >= 0 && y - k < H) << "y=" << y << " k=" << k;
      // The newest pair completes cost column x-(D-1) in row y, the bottom of the window around row y-r.
      const int cost_x = x - (D - 1), centre_y = y - r;
      const bool output_row = centre_y >= 0 && centre_y < H;
      ASSERT_EQ(delay.tag.cost_column, cost_x >= 0) << "x=" << x;
      ASSERT_EQ(delay.tag.output_column, output_row && cost_x >= 0 && cost_x < W - D) << "x=" << x << " y=" << y;
      if (!delay.tag.output_column) continue;
      ASSERT_EQ(delay.tag.start_of_frame, cost_x == 0 && centre_y == 0) << "x=" << x << " y=" << y;
      ASSERT_EQ(delay.tag.end_of_line, cost_x == W - D - 1) << "x=" << x << " y=" << y;
   }
}

TYPED_TEST(ReferenceDelayTest, DelaysTheRightImageAndTagsThePlace) {
   delays_the_right_image_and_tags_the_place<TypeParam::kConfig>();
}

}  // namespace
}  // namespace stereo::test
