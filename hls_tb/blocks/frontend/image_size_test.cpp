// SPDX-License-Identifier: Apache-2.0
#include "frontend/image_size.hpp"

#include <gtest/gtest.h>

#include <set>

#include "block_matching/config.hpp"
#include "support/least_size.hpp"
#include "testing/test_configs.hpp"

namespace stereo::test {
namespace {

template <Reference Side, int MinDisparity, int Window>
using SizeConfig =
    Exactly<block_matching::Config{{.width_px = 30, .height_px = 16, .pixels_per_clock = 2},
                                   {DisparityCount{7}, MatchingWindow{Window}, SmallestDisparity{MinDisparity},
                                    ReferenceImage{Side}, FullWidth{.full_width = true}},
                                   {RunTime{.run_time_size = true}}}>;

/// The reference lags behind by 6, 9, 0, 0, 4 and 11 columns.
using Configs = ::testing::Types<SizeConfig<Reference::right, 0, 3>, SizeConfig<Reference::right, 3, 6>,
                                 SizeConfig<Reference::right, -9, 3>, SizeConfig<Reference::left, 2, 5>,
                                 SizeConfig<Reference::left, -4, 2>, SizeConfig<Reference::left, -11, 4>>;
template <class Config>
class ImageSizeTest : public ::testing::Test {};
TYPED_TEST_SUITE(ImageSizeTest, Configs, ConfigNames);

std::set<int> columns_of(const ColumnRange& range, int width) {
   std::set<int> columns;
   for (int x = 0; x < width; ++x)
      if (range.has(uint16_t(x))) columns.insert(x);
   return columns;
}

/// By definition: the reference's column that comes with column x of the other image is `lag` columns before it, at the
/// end of the row before where x is less.
template <class Holds>
std::set<int> expected_columns(int width, int lag, Holds holds) {
   std::set<int> columns;
   for (int x = 0; x < width; ++x)
      if (holds(x >= lag ? x - lag : x - lag + width)) columns.insert(x);
   return columns;
}

TYPED_TEST(ImageSizeTest, FindsTheColumnsOfAMapOfFullWidth) {
   static constexpr block_matching::Config C = TypeParam::kConfig;
   constexpr int B = C.window_px;
   const int newest = C.reference == Reference::right ? C.min_disparity + C.disparities - 1 : -C.min_disparity;
   const int lag = newest > 0 ? newest : 0;
   RunTimeSize<C> size;
   const auto expect_columns = [&](int width) {
      SCOPED_TRACE(width);
      EXPECT_EQ(columns_of(size.leaving_columns, width), expected_columns(width, lag, [&](int x) { return x >= B; }));
      // Columns of the window before its centre: of an even window one more, in the mirror image one less.
      const int before = C.reference == Reference::right ? B / 2 : (B - 1) / 2;
      const auto is_centre = [&](int x) { return x >= before && x - before + B <= width; };
      EXPECT_EQ(columns_of(size.map_columns, width), expected_columns(width, lag, is_centre));
      EXPECT_EQ(size.map_columns.from, (before + lag) % width);
      EXPECT_EQ(size.map_columns.to, (width - B + before + lag) % width);
   };
   expect_columns(C.width_px);
   for (int width = least_size(C).width_px; width <= C.width_px; ++width) {
      size.clock(uint16_t(width), uint16_t(C.height_px));
      expect_columns(width);
   }
   EXPECT_EQ(columns_of(FixedSize<C>::map_columns, C.width_px), columns_of(size.map_columns, C.width_px));
   EXPECT_EQ(columns_of(FixedSize<C>::leaving_columns, C.width_px), columns_of(size.leaving_columns, C.width_px));
}

TYPED_TEST(ImageSizeTest, CountsTheGroupsOfRows) {
   static constexpr block_matching::Config C = TypeParam::kConfig;
   RunTimeSize<C> size;
   for (int groups = least_size(C).row_groups(); groups <= C.row_groups(); ++groups) {
      size.clock(uint16_t(C.width_px), uint16_t(2 * groups));
      EXPECT_EQ(size.windows.groups, groups);
      EXPECT_EQ(size.windows.last_group, groups - 1);
      EXPECT_EQ(size.windows.idle, groups + C.delay_groups());
   }
}

}  // namespace
}  // namespace stereo::test
