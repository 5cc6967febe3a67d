// SPDX-License-Identifier: Apache-2.0
#include "semi_global/config.hpp"

#include <gtest/gtest.h>

#include <string>

#include "semi_global/configurations.hpp"
#include "semi_global/settings.hpp"

namespace stereo::test {
namespace {

using semi_global::Config;

constexpr Config kGood{{.width_px = 40, .height_px = 12}, {DisparityCount{12}}, {}};

std::string problem(void (*change)(Config&)) {
   Config config = kGood;
   change(config);
   return config.problem().text;
}

TEST(SemiGlobalConfig, SaysWhatCannotBeFolded) {
   EXPECT_EQ(problem([](Config& c) { c.clocks_per_pixel = 4; }), "");
   EXPECT_EQ(problem([](Config& c) { c.clocks_per_pixel = 6; }), "");
   EXPECT_EQ(problem([](Config& c) { c.clocks_per_pixel = 5; }),
             "the clocks a pixel pair must divide the disparity range");
   EXPECT_EQ(problem([](Config& c) { c.clocks_per_pixel = 3; }),
             "the loop of a semi-global path takes four clocks a pixel pair or more, or one");
   EXPECT_EQ(problem([](Config& c) { c.clocks_per_pixel = 12; }),
             "with several clocks a pixel pair two disparities or more must be left for each");
   EXPECT_EQ(problem([](Config& c) {
                c.clocks_per_pixel = 4;
                c.aggregation = Aggregation::recursive;
             }),
             "with several clocks a pixel pair semi-global costs have no recursive sums");
   EXPECT_EQ(problem([](Config& c) {
                c.clocks_per_pixel = 64;
                c.disparities = 128;
                c.width_px = 1300;
             }),
             "with so many clocks a pixel pair a row of the map must be shorter");
   EXPECT_EQ(problem([](Config& c) {
                c.clocks_per_pixel = 4;
                c.front_clocks = 2;
             }),
             "");
   EXPECT_EQ(problem([](Config& c) { c.front_clocks = 2; }),
             "with two clocks of the comparisons in front a pixel pair must take three clocks or more");
}

TEST(SemiGlobalConfig, SaysWhatCannotBeBuilt) {
   EXPECT_EQ(problem([](Config&) {}), "");
   EXPECT_EQ(problem([](Config& c) { c.pixels_per_clock = 2; }), "the semi-global core takes one pixel pair a clock");
   EXPECT_EQ(problem([](Config& c) { c.disparities = 7; }), "the disparity range must be 8 ... 256");
   EXPECT_EQ(problem([](Config& c) { c.disparities = 10; }),
             "the disparity range must leave 11 columns between the maps of two rows but leaves 9");
   EXPECT_EQ(problem([](Config& c) { c.width_px = 12; }), "the image must be wider than the disparity range");
   EXPECT_EQ(problem([](Config& c) { c.window_px = 32; }), "the matching window must be 2x2 ... 31x31 pixels");
   EXPECT_EQ(problem([](Config& c) {
                c.window_px = 1;
                c.aggregation = Aggregation::recursive;
             }),
             "a single pixel has no recursive sum");
   EXPECT_EQ(problem([](Config& c) {
                c.full_width = true;
                c.window_px = 2;
             }),
             "a semi-global map of full width needs a window of 3x3 pixels or more");
   EXPECT_EQ(problem([](Config& c) {
                c.full_width = true;
                c.disparities = 8;
                c.width_px = 13;
             }),
             "with a map of full width the image must be 14 columns wide or more");
   EXPECT_EQ(problem([](Config& c) { c.p1 = -1; }), "the penalty P1 is -1 but must be 0 ... 4095");
   EXPECT_EQ(problem([](Config& c) { c.sign_memory = true; }), "a sign memory is for block matching");
   EXPECT_EQ(problem([](Config& c) { c.run_time_settings = true; }), "");
   EXPECT_EQ(
       problem([](Config& c) {
          c.run_time_settings = true;
          c.height_px = 6;
       }),
       "with run-time settings the image must be higher, for a frame's first disparity to leave before the next one");
   EXPECT_EQ(problem([](Config& c) { c.winner_group = 1; }),
             "the number of candidates of a winner group is 1 but must be 2 ... 16");
   EXPECT_EQ(problem([](Config& c) { c.path_left = c.path_right = c.path_above = false; }),
             "at least one path must be on");
}

TEST(SemiGlobalConfig, PortsWidenNoPath) {
   Config config = kGood;
   config.run_time_settings = true;
   config.uniqueness_distance = 3;
   const SettingList list = setting_list(config);
   ASSERT_EQ(list.count, 10);
   const int largest[] = {5, 22, 0, 0, 0, config.largest_sum(), 0, 0, 0, 0};
   const int start[] = {5, 22, 0, 0, 0, 3, 0, 0, 0, 0};
   for (int i = 0; i < list.count; ++i) {
      EXPECT_EQ(list.setting[i].largest, largest[i]) << list.setting[i].name;
      EXPECT_EQ(list.setting[i].start, start[i]) << list.setting[i].name;
   }
   // K and A: -(22 + 13 - P1) ... 2*13 + 5, in 6 bits from P1 = 3 on.
   EXPECT_EQ(list.setting[0].least, 3);
   EXPECT_EQ(list.setting[1].least, 0);
   for (int p1 = 0; p1 <= 40; ++p1)
      for (int p2 = 0; p2 <= 60; ++p2) {
         Config fixed = config;
         fixed.run_time_settings = false;
         fixed.p1 = config.p1 = p1;
         fixed.p2 = config.p2 = p2;
         ASSERT_EQ(config.row_path_bits(), fixed.row_path_bits());
         ASSERT_EQ(config.largest_sum(), fixed.largest_sum());
         ASSERT_LE(config.least_p1(), p1);
         // It is the smallest: one less needs another bit.
         fixed.p1 = config.least_p1();
         ASSERT_LE(fixed.row_path_bits(), config.row_path_bits()) << p1 << ' ' << p2;
         if (fixed.p1-- == 0) continue;
         ASSERT_GT(fixed.row_path_bits(), config.row_path_bits()) << p1 << ' ' << p2;
      }
   config.path_left = config.path_right = false;
   EXPECT_EQ(config.least_p1(), 0) << "the path from above has no sign";
}

TEST(SemiGlobalConfig, PortsSetWhatTheCoreHasOfTheRoad) {
   Config config = kGood;
   config.run_time_settings = true;
   config.p2 = 60;
   config.p2_least = 20;
   config.above_p2 = 31;
   const SettingList list = setting_list(config);
   const auto is = [&list](int number, const char* name, int least, int largest, int start) {
      const Setting& setting = list.setting[number];
      EXPECT_EQ(setting.name, std::string(name));
      EXPECT_EQ(setting.least, least) << name;
      EXPECT_EQ(setting.largest, largest) << name;
      EXPECT_EQ(setting.start, start) << name;
   };
   is(2, "p2_least", 20, 60, 20);
   is(3, "above_p1", 0, 5, 5);
   is(4, "above_p2", 0, 31, 31);
   EXPECT_EQ(config.largest_path_above(), 31 + 13);
}

TEST(SemiGlobalConfig, BitsOfARowPathHoldTheFallOfP2) {
   Config config = kGood;
   config.cost_cap = 5;
   config.p1 = 7;
   config.p2 = 60;
   EXPECT_EQ(config.row_path_bits(), 7);
   config.p2_least = 20;  // K, A: -60 ... 2*5 + 7 + 40
   EXPECT_EQ(config.row_path_bits(), 7);
   EXPECT_EQ(config.largest_row_path(), 5 + 40);
   config.left_right_threshold = 1;
   EXPECT_EQ(config.largest_row_path(), 5) << "the sums of two columns are compared";
   config.p2_least = 12;  // 2*5 + 7 + 48
   EXPECT_EQ(config.row_path_bits(), 8);
   config.clocks_per_pixel = 4;  // K and A without a relief
   EXPECT_EQ(config.row_path_bits(), 7);
   config.left_right_threshold = -1;
   EXPECT_EQ(config.largest_row_path(), 5);
   config.clocks_per_pixel = 1;
   config.p2_least = 60;
   EXPECT_FALSE(config.has_relief());
   config.p2_least = 20;
   config.path_left = config.path_right = false;
   EXPECT_FALSE(config.has_relief()) << "only rows have one";
}

/// The limits of the window costs, and of the rows that are turned round: 11 columns between two maps.
TEST(SemiGlobalConfig, SaysWhichSizesARunTimeSizeCanHave) {
   Config config = kGood;
   config.run_time_size = true;
   EXPECT_EQ(config.problem().text, std::string());
   EXPECT_EQ(least_size(config).width_px, 11 + 3);
   EXPECT_EQ(least_size(config).height_px, 3);
   const SettingList list = setting_list(config);
   ASSERT_EQ(list.count, 12);
   for (int i = 0; i < 10; ++i) EXPECT_EQ(list.setting[i].largest, 0) << list.setting[i].name;
   EXPECT_EQ(list.setting[10].name, std::string("image_width"));
   EXPECT_EQ(list.setting[10].largest, 40);
   EXPECT_EQ(list.setting[10].least, 14);
   EXPECT_EQ(list.setting[11].largest, 12);
   EXPECT_EQ(list.setting[11].least, 3);
   config.full_width = true;
   EXPECT_EQ(least_size(config).width_px, 11 + 4) << "a row's last column must be there when the next one comes";
   config.full_width = false;
   config.run_time_settings = true;
   const Image least = least_size(config);
   config.width_px = least.width_px;
   config.height_px = least.height_px;
   EXPECT_EQ(config.problem().text, std::string());
   --config.height_px;
   EXPECT_NE(config.problem().text, std::string()) << "a frame's first disparity leaves before the next frame";
}

TEST(SemiGlobalConfig, AFewDisparitiesDoWhereTheyAreFar) {
   EXPECT_EQ(problem([](Config& c) {
                c.disparities = 8;
                c.min_disparity = 3;
             }),
             "");
}

TEST(SemiGlobalConfig, TheMapHasAllCostColumns) {
   EXPECT_EQ(kGood.output_width_px(), 29);
   EXPECT_EQ(semi_global::configurations::sgm_450.output_width_px(), 450 - 63);
}

TEST(SemiGlobalConfig, FindsTheBitsOfThePaths) {
   // Census 5x5, window 3x3, shift 4: costs up to 13. K and A: -(22 + 8) ... 2*13 + 5.
   EXPECT_EQ(kGood.largest_cost(), 13);
   EXPECT_EQ(kGood.row_path_bits(), 6);
   EXPECT_EQ(kGood.largest_path_above(), 35);
   EXPECT_EQ(kGood.largest_sum(), 2 * (32 + 13) + 35);
   Config config = kGood;
   config.p2 = 24;  // -(24 + 8) just fits
   EXPECT_EQ(config.row_path_bits(), 6);
   config.p2 = 25;
   EXPECT_EQ(config.row_path_bits(), 7);
   config.cost_cap = 10;
   EXPECT_EQ(config.largest_cost(), 10);
}

}  // namespace
}  // namespace stereo::test
