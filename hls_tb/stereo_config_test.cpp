// SPDX-License-Identifier: Apache-2.0
#include "stereo_config.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <string_view>

#include "configurations.hpp"
#include "support/test_configs.hpp"
#include "vectors/configuration_table.hpp"
#include "vectors/matching_parameters.hpp"

namespace stereo::test {
namespace {

TEST(StereoConfig, AmbroschIsThePapersConfiguration) {
   constexpr StereoConfig C = configurations::ambrosch2007;
   EXPECT_EQ(C.width_px, 320);
   EXPECT_EQ(C.height_px, 240);
   EXPECT_EQ(C.disparities, 100);
   EXPECT_EQ(C.window_px, 3);
   EXPECT_EQ(C.output_width_px(), 220);
   EXPECT_EQ(C.output_height_px(), 240);
   EXPECT_EQ(C.largest_window_cost(), 9 * 255);
   EXPECT_EQ(C.disparity_bits(), 8);
}

/// By definition: the lowest window of a group of P rows ends rows_below below it; all of them cover P + B - 1 rows, of
/// which the newest group gives those that it holds. Recursive sums need the row above them, too.
TEST(StereoConfig, RowsOfTheWindowsFollowFromTheirSide) {
   for (const Aggregation aggregation : {Aggregation::direct, Aggregation::recursive})
      for (const int window : {2, 3, 4, 5, 8, 31})
         for (const int pixels : {1, 2, 4}) {
            const StereoConfig config{.width_px = 64,
                                      .height_px = 48,
                                      .disparities = 32,
                                      .window_px = window,
                                      .pixels_per_clock = pixels,
                                      .aggregation = aggregation};
            SCOPED_TRACE(config_name(config));
            int above = 0, below = 0;  // rows beside the centre: of an even window one more above
            for (int row = 1; row < window; ++row) ++(row % 2 == 1 ? above : below);
            EXPECT_EQ(config.rows_above(), above);
            EXPECT_EQ(config.rows_below(), below);
            int delay = 0;
            while (delay * pixels < below) ++delay;
            EXPECT_EQ(config.delay_groups(), delay);
            EXPECT_EQ(config.row_groups(), 48 / pixels);
            const std::vector<int> taps = tap_offsets(config);
            ASSERT_EQ(config.tap_rows(), int(taps.size()));
            for (std::size_t t = 0; t < taps.size(); ++t) EXPECT_EQ(config.top_row() + config.tap_row(int(t)), taps[t]);
            const int newest_group = delay * pixels;  // seen from the first row of the windows' centres
            EXPECT_EQ(config.stored_rows(), newest_group - taps[0]);
         }
}

TEST(StereoConfig, TheSizeOfTheMapIsThatOfTheModels) {
   for (const Reference reference : {Reference::right, Reference::left})
      for (int min_disparity = -40; min_disparity <= 20; ++min_disparity) {
         const StereoConfig config{.width_px = 50,
                                   .height_px = 20,
                                   .disparities = 10,
                                   .min_disparity = min_disparity,
                                   .reference = reference};
         const MatchingParameters parameters = matching_parameters(config);
         SCOPED_TRACE(config_name(config));
         EXPECT_EQ(config.cost_columns(), cost_columns(50, parameters));
         EXPECT_EQ(config.output_width_px(), map_width(50, parameters));
         EXPECT_EQ(config.output_first_column(), map_first_column(parameters));
      }
}

/// Plain core: the last window needs the rows below it, then the columns of its row that come after it.
TEST(StereoConfig, FlushGroupsBringOutTheLastDisparity) {
   constexpr StereoConfig kPlain = configurations::ambrosch2007;
   EXPECT_EQ(kPlain.flush_groups(), kPlain.width_px);
   StereoConfig config = configurations::tiny;
   EXPECT_EQ(config.flush_groups(), config.width_px);
   config.window_px = 2;  // no row and no column below its centre, and the map lacks the last column
   EXPECT_EQ(config.flush_groups(), 0);
   config.reference = Reference::left;
   EXPECT_EQ(config.flush_groups(), 1);
}

TEST(StereoConfig, LargestCosts) {
   EXPECT_EQ(
       (StereoConfig{.width_px = 320, .height_px = 240, .disparities = 64, .cost = Cost::ssd}).largest_pixel_cost(),
       65025);
   EXPECT_EQ(
       (StereoConfig{.width_px = 320, .height_px = 240, .disparities = 64, .cost = Cost::census}).largest_pixel_cost(),
       24);
   EXPECT_EQ((StereoConfig{.width_px = 320,
                           .height_px = 240,
                           .disparities = 64,
                           .cost = Cost::census,
                           .census_width_px = 9,
                           .census_height_px = 7})
                 .largest_pixel_cost(),
             62);
   EXPECT_EQ((StereoConfig{.width_px = 320, .height_px = 240, .disparities = 64, .prefilter = Prefilter::xsobel})
                 .largest_pixel_cost(),
             62);
   EXPECT_EQ((StereoConfig{.width_px = 320,
                           .height_px = 240,
                           .disparities = 64,
                           .cost = Cost::ssd,
                           .prefilter = Prefilter::xsobel,
                           .prefilter_cap = 63})
                 .largest_pixel_cost(),
             126 * 126);
   EXPECT_EQ((StereoConfig{.width_px = 320, .height_px = 240, .disparities = 64, .window_px = 31, .cost = Cost::ssd})
                 .largest_window_cost(),
             65025 * 961);
}

TEST(StereoConfig, OnlyTheRowsAtOnceTellThePapersConfigurationsApart) {
   EXPECT_EQ(configurations::ambrosch2007.pixels_per_clock, 1);
   EXPECT_EQ(configurations::ambrosch2007_p2.pixels_per_clock, 2);
   EXPECT_EQ(configurations::ambrosch2007_p4.pixels_per_clock, 4);
   for (const StereoConfig& config : {configurations::ambrosch2007_p2, configurations::ambrosch2007_p4}) {
      EXPECT_EQ(config.width_px, 320);
      EXPECT_EQ(config.height_px, 240);
      EXPECT_EQ(config.disparities, 100);
      EXPECT_EQ(config.window_px, 3);
   }
}

TEST(ConfigurationTable, FindsEveryNameAndNoOther) {
   for (const Configuration& entry : configuration_table()) EXPECT_EQ(find_configuration(entry.name), &entry);
   EXPECT_EQ(find_configuration("no such configuration"), nullptr);
#define STEREO_NAME(name) #name,
   const std::set<std::string> names{STEREO_FOR_EACH_CONFIGURATION(STEREO_NAME)};
#undef STEREO_NAME
   if (std::string_view(STEREO_CONFIGURATIONS) != "")
      GTEST_SKIP() << "SKIP: this build (STEREO_CONFIGURATIONS) has only " << STEREO_CONFIGURATIONS;
   EXPECT_EQ(configuration_table().size(), names.size()) << "a name stands there twice";
   for (const std::string& name : names) EXPECT_NE(find_configuration(name), nullptr) << name;
}

}  // namespace
}  // namespace stereo::test
