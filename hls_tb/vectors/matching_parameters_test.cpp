// SPDX-License-Identifier: Apache-2.0
// A configuration and its parameters mean the same.
#include "vectors/matching_parameters.hpp"

#include <gtest/gtest.h>

namespace stereo::test {
namespace {

TEST(MatchingParameters, HaveTheDefaultsOfStereoConfig) {
   const MatchingParameters p{.disparities = 8};
   const MatchingParameters c = matching_parameters({.width_px = 32, .height_px = 12, .disparities = 8});
   EXPECT_EQ(c.disparities, p.disparities);
   EXPECT_EQ(c.window_px, p.window_px);
   EXPECT_EQ(c.min_disparity, p.min_disparity);
   EXPECT_EQ(c.reference, p.reference);
   EXPECT_EQ(c.cost, p.cost);
   EXPECT_EQ(c.census_width_px, p.census_width_px);
   EXPECT_EQ(c.census_height_px, p.census_height_px);
   EXPECT_EQ(c.prefilter, p.prefilter);
   EXPECT_EQ(c.prefilter_cap, p.prefilter_cap);
   EXPECT_EQ(c.ties, p.ties);
   EXPECT_EQ(c.left_right_threshold, p.left_right_threshold);
   EXPECT_EQ(c.uniqueness_percent, p.uniqueness_percent);
   EXPECT_EQ(c.texture_threshold, p.texture_threshold);
   EXPECT_EQ(c.subpixel, p.subpixel);
   EXPECT_EQ(c.median, p.median);
}

TEST(MatchingParameters, CarryEveryOption) {
   const MatchingParameters p = matching_parameters({.width_px = 32,
                                                     .height_px = 12,
                                                     .disparities = 9,
                                                     .window_px = 4,
                                                     .min_disparity = -3,
                                                     .reference = Reference::left,
                                                     .cost = Cost::ssd,
                                                     .census_width_px = 7,
                                                     .census_height_px = 3,
                                                     .prefilter = Prefilter::xsobel,
                                                     .prefilter_cap = 12,
                                                     .ties = Ties::largest,
                                                     .left_right_threshold = 2,
                                                     .uniqueness_percent = 15,
                                                     .texture_threshold = 6,
                                                     .subpixel = true,
                                                     .median = true});
   EXPECT_EQ(p.disparities, 9);
   EXPECT_EQ(p.window_px, 4);
   EXPECT_EQ(p.min_disparity, -3);
   EXPECT_EQ(p.reference, Reference::left);
   EXPECT_EQ(p.cost, Cost::ssd);
   EXPECT_EQ(p.census_width_px, 7);
   EXPECT_EQ(p.census_height_px, 3);
   EXPECT_EQ(p.prefilter, Prefilter::xsobel);
   EXPECT_EQ(p.prefilter_cap, 12);
   EXPECT_EQ(p.ties, Ties::largest);
   EXPECT_EQ(p.left_right_threshold, 2);
   EXPECT_EQ(p.uniqueness_percent, 15);
   EXPECT_EQ(p.texture_threshold, 6);
   EXPECT_TRUE(p.subpixel);
   EXPECT_TRUE(p.median);
}

TEST(MatchingParameters, PlaceTheMapWhereTheConfigurationDoes) {
   int compared = 0;
   for (const Reference reference : {Reference::right, Reference::left})
      for (const int disparities : {2, 8, 31})
         for (int min_disparity = -35; min_disparity <= 35; ++min_disparity) {
            const StereoConfig config{.width_px = 40,
                                      .height_px = 12,
                                      .disparities = disparities,
                                      .min_disparity = min_disparity,
                                      .reference = reference};
            if (config.cost_columns() < 2) continue;
            const MatchingParameters parameters = matching_parameters(config);
            EXPECT_EQ(map_width(config.width_px, parameters), config.output_width_px()) << min_disparity;
            EXPECT_EQ(map_first_column(parameters), config.output_first_column()) << min_disparity;
            ++compared;
         }
   EXPECT_GT(compared, 200);
}

TEST(MatchingParameters, KnowTheSameLargestCosts) {
   for (const Cost cost : {Cost::sad, Cost::ssd, Cost::census})
      for (const Prefilter prefilter : {Prefilter::none, Prefilter::xsobel}) {
         const StereoConfig config{
             .width_px = 40, .height_px = 12, .disparities = 8, .cost = cost, .prefilter = prefilter};
         EXPECT_EQ(matching_parameters(config).largest_pixel_cost(), config.largest_pixel_cost());
      }
}

}  // namespace
}  // namespace stereo::test
