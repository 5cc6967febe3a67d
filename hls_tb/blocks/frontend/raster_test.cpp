// SPDX-License-Identifier: Apache-2.0
#include "frontend/raster.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "block_matching/config.hpp"
#include "frontend/features.hpp"
#include "scene/random.hpp"
#include "testing/seed.hpp"
#include "testing/test_configs.hpp"

namespace stereo::test {
namespace {

/// The definition: a record's place follows from how many records came since the start of its frame. A frame that
/// starts right behind a whole one first serves as the rows below that one, unless sums are recursive.
struct Counted {
   int64_t since_start = -1;  ///< -1: no frame yet
   bool back_to_back = false;

   void record(bool start_of_frame, const block_matching::Config& config) {
      if (start_of_frame) {
         back_to_back = config.aggregation == Aggregation::direct &&
                        since_start == int64_t(config.width_px) * config.row_groups() - 1;
         since_start = 0;
      } else if (since_start >= 0) {
         ++since_start;
      }
   }
   int column(const block_matching::Config& config) const { return int(since_start % config.width_px); }
   int64_t group(const block_matching::Config& config) const {
      const int64_t idle = config.row_groups() + config.delay_groups();
      if (since_start < 0) return idle;
      const int64_t groups = since_start / config.width_px;
      if (back_to_back && groups < config.delay_groups()) return config.row_groups() + groups;
      return std::min(groups, idle);
   }
};

template <class Config>
class RasterTest : public ::testing::Test {};
TYPED_TEST_SUITE(RasterTest, AllSmallConfigs, ConfigNames);

TYPED_TEST(RasterTest, CountsColumnsAndGroupsOfRows) {
   static constexpr block_matching::Config C = TypeParam::kConfig;
   Random random(test_seed());
   Raster<C> raster;
   Counted expected;
   const int64_t frame = int64_t(C.width_px) * C.row_groups();
   int64_t until_start = 5;
   for (int i = 0; i < 60 * frame; ++i) {
      const bool valid = !random.percent(25);
      const bool starts = valid && until_start-- == 0;
      if (starts) {  // the next frame: right behind this one, after flush groups, much later, or in its middle
         const int64_t lengths[] = {frame, frame, frame + C.delay_groups() * C.width_px, frame + 3 * C.width_px + 1,
                                    1 + random.below(int(frame))};
         until_start = lengths[random.below(5)] - 1;
      }
      FeatureGroup<C> in;
      in.start_of_frame = valid ? starts : random.percent(50);
      in.valid = valid;
      raster.clock(in);
      if (valid) expected.record(starts, C);
      ASSERT_EQ(raster.features.valid, valid);
      ASSERT_EQ(raster.place.group, expected.group(C)) << "record " << expected.since_start << " clock " << i;
      if (expected.since_start < 0) continue;
      ASSERT_EQ(raster.place.column, expected.column(C)) << "clock " << i;
   }
}

TYPED_TEST(RasterTest, PassesThePixelsOn) {
   static constexpr block_matching::Config C = TypeParam::kConfig;
   Random random(test_seed());
   Raster<C> raster;
   for (int i = 0; i < 100; ++i) {
      FeatureGroup<C> in;
      in.valid = true;
      for (int p = 0; p < C.pixels_per_clock; ++p) {
         in.search[p] = random.byte();
         in.reference[p] = random.byte();
      }
      raster.clock(in);
      for (int p = 0; p < C.pixels_per_clock; ++p) {
         ASSERT_EQ(raster.features.search[p], in.search[p]) << "lane " << p;
         ASSERT_EQ(raster.features.reference[p], in.reference[p]) << "lane " << p;
      }
   }
}

}  // namespace
}  // namespace stereo::test
