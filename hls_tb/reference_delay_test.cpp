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
TYPED_TEST_SUITE(ReferenceDelayTest, SmallConfigs, ConfigNames);

/// The newest record, column x of group g, completes cost column x-(D-1) in the windows around group g - delay.
template <const StereoConfig& C>
void expect_tags(const ReferenceDelay<C>& delay, int x, int g) {
   constexpr int W = C.width_px, H = C.height_px, D = C.disparities, P = C.pixels_per_clock;
   const int cost_x = x - (D - 1), centre_y = (g - C.delay_groups()) * P;
   for (int t = 0; t < C.tap_rows(); ++t) {
      const int y = centre_y - C.radius_px() + t;
      ASSERT_EQ(delay.row_inside[t], y >= 0 && y < H) << "group " << g << " t=" << t;
   }
   const bool output = centre_y >= 0 && centre_y < H && cost_x >= 0 && cost_x < W - D;
   ASSERT_EQ(delay.tag.border_column, cost_x < 0) << "x=" << x;
   ASSERT_EQ(delay.tag.output_column, output) << "x=" << x << " group " << g;
   if (!output) return;
   ASSERT_EQ(delay.tag.start_of_frame, cost_x == 0 && centre_y == 0) << "x=" << x << " group " << g;
   ASSERT_EQ(delay.tag.end_of_line, cost_x == W - D - 1) << "x=" << x << " group " << g;
}

TYPED_TEST(ReferenceDelayTest, DelaysTheRightImageAndTagsThePlace) {
   static constexpr StereoConfig C = TypeParam::kConfig;
   constexpr int W = C.width_px, D = C.disparities, P = C.pixels_per_clock;
   Random random(test_seed());
   typename ReferenceDelay<C>::Memory memory{};
   ReferenceDelay<C> delay(memory);
   Raster<C> raster;
   std::vector<uint32_t> rights;
   for (int n = 0; n < W * (Raster<C>::kIdle + 1);) {
      const int x = n % W, g = n / W;
      for (int p = 0; p < P; ++p) raster.left[p] = random.byte();
      raster.right = uint_of_bits<8 * P>(random.bits());
      raster.valid = !random.percent(25);
      raster.column = uint16_t(x);
      raster.group = uint16_t(g);
      delay.clock(raster);
      ASSERT_EQ(delay.tag.valid, raster.valid);
      if (!raster.valid) continue;
      rights.push_back(raster.right);
      ++n;
      if (n >= D) {
         ASSERT_EQ(delay.right, rights[std::size_t(n - D)]) << "x=" << x << " group " << g;
      }
      for (int p = 0; p < P; ++p) ASSERT_EQ(delay.left[p], raster.left[p]) << "lane " << p;
      ASSERT_EQ(delay.column, x);
      ASSERT_NO_FATAL_FAILURE(expect_tags<C>(delay, x, g));
   }
}

}  // namespace
}  // namespace stereo::test
