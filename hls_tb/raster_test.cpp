// SPDX-License-Identifier: Apache-2.0
#include "raster.hpp"

#include <gtest/gtest.h>

#include "models/random.hpp"
#include "support/seed.hpp"
#include "support/test_configs.hpp"

namespace stereo::test {
namespace {

/// The definition: a pair's place follows from how many pairs came since the start of its frame. A frame that starts
/// right behind a whole one first serves as the rows below that one.
struct Counted {
   int64_t since_start = -1;  ///< -1: no frame yet
   bool back_to_back = false;

   void pair(bool start_of_frame, const StereoConfig& config) {
      if (start_of_frame) {
         back_to_back = since_start == int64_t(config.width_px) * config.height_px - 1;
         since_start = 0;
      } else if (since_start >= 0) {
         ++since_start;
      }
   }
   int column(const StereoConfig& config) const { return int(since_start % config.width_px); }
   int64_t row(const StereoConfig& config) const {
      const int64_t idle = config.height_px + config.radius_px();
      if (since_start < 0) return idle;
      const int64_t rows = since_start / config.width_px;
      if (back_to_back && rows < config.radius_px()) return config.height_px + rows;
      return std::min(rows, idle);
   }
};

template <class Config>
class RasterTest : public ::testing::Test {};
TYPED_TEST_SUITE(RasterTest, SmallConfigs);

template <const StereoConfig& C>
void counts_columns_and_rows() {
   Random random(test_seed());
   Raster<C> raster;
   Counted expected;
   const int64_t frame = int64_t(C.width_px) * C.height_px;
   int64_t until_start = 5;
   for (int i = 0; i < 60 * frame; ++i) {
      const bool valid = !random.percent(25);
      const bool starts = valid && until_start-- == 0;
      if (starts) {  // the next frame: right behind this one, after flush rows, much later, or in its middle
         const int64_t lengths[] = {frame, frame, frame + C.radius_px() * C.width_px, frame + 3 * C.width_px + 1,
                                    1 + random.below(int(frame))};
         until_start = lengths[random.below(5)] - 1;
      }
      raster.clock(
          {.left = random.byte(), .right = 7, .start_of_frame = valid ? starts : random.percent(50), .valid = valid});
      if (valid) expected.pair(starts, C);
      ASSERT_EQ(raster.valid, valid);
      ASSERT_EQ(raster.row, expected.row(C)) << "pair " << expected.since_start << " clock " << i;
      if (expected.since_start < 0) continue;
      ASSERT_EQ(raster.column, expected.column(C)) << "clock " << i;
   }
}

TYPED_TEST(RasterTest, CountsColumnsAndRows) { counts_columns_and_rows<TypeParam::kConfig>(); }

TEST(Raster, PassesThePixelsOn) {
   Raster<configurations::tiny> raster;
   raster.clock({.left = 12, .right = 34, .start_of_frame = true, .valid = true});
   EXPECT_EQ(raster.left, 12);
   EXPECT_EQ(raster.right, 34);
}

}  // namespace
}  // namespace stereo::test
