// SPDX-License-Identifier: Apache-2.0
#include "stereo_config.hpp"

#include <gtest/gtest.h>

#include <set>

#include "support/test_configs.hpp"
#include "vectors/configuration_table.hpp"

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
}

/// By definition: the lowest window of a group of P rows ends r rows below it; all of them cover P + 2r rows, of which
/// the newest group gives those that it holds.
TEST(StereoConfig, RowsOfTheWindowsFollowFromTheirRadius) {
   for (const int window : {3, 5})
      for (const int pixels : {1, 2, 4}) {
         const StereoConfig config{
             .width_px = 32, .height_px = 16, .disparities = 8, .window_px = window, .pixels_per_clock = pixels};
         const int r = window / 2;
         EXPECT_EQ(config.radius_px(), r);
         int delay = 0;
         while (delay * pixels < r) ++delay;
         EXPECT_EQ(config.delay_groups(), delay) << "P=" << pixels << " B=" << window;
         EXPECT_EQ(config.row_groups(), 16 / pixels);
         EXPECT_EQ(config.tap_rows(), pixels + 2 * r);
         const int top = -r, newest_group = delay * pixels;  // seen from the first row of the windows' centres
         EXPECT_EQ(config.stored_rows(), newest_group - top) << "P=" << pixels << " B=" << window;
      }
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
   std::set<std::string> names;
   for (const Configuration& entry : configuration_table()) {
      EXPECT_EQ(find_configuration(entry.name), &entry);
      EXPECT_TRUE(names.insert(entry.name).second) << entry.name << " stands there twice";
   }
   for (const char* name : {"ambrosch2007", "ambrosch2007_p2", "ambrosch2007_p4", "tiny", "tiny_p2", "tiny_p4"})
      EXPECT_TRUE(names.contains(name)) << name;
   EXPECT_EQ(find_configuration("no such configuration"), nullptr);
}

}  // namespace
}  // namespace stereo::test
