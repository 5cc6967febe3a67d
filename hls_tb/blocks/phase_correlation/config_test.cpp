// SPDX-License-Identifier: Apache-2.0
#include "phase_correlation/config.hpp"

#include <gtest/gtest.h>

#include <string>

#include "phase_correlation/settings.hpp"

namespace stereo::test {
namespace {

constexpr phase_correlation::Config kChecked{
    {.width_px = 40, .height_px = 18},
    {DisparityCount{12}, MatchingWindow{5}, LeftRightThreshold{1}, UniquenessPercent{10}},
    {}};

TEST(PhaseCorrelationConfig, SettingsAreThoseOfItsChecks) {
   phase_correlation::Config config = kChecked;
   config.uniqueness_percent = 0;
   config.run_time_settings = true;
   ASSERT_EQ(config.problem().text, std::string());
   const SettingList list = setting_list(config);
   ASSERT_EQ(list.count, 5);
   EXPECT_EQ(list.setting[0].name, std::string("uniqueness_percent"));
   EXPECT_EQ(list.setting[0].largest, 0) << "there is no such check";
   EXPECT_EQ(list.setting[1].name, std::string("left_right_threshold"));
   EXPECT_EQ(list.setting[1].largest, 11);
   EXPECT_EQ(list.setting[1].start, 1);
   EXPECT_EQ(list.setting[2].largest, 0) << "the whole range fits at each column";
   EXPECT_EQ(list.setting[4].name, std::string("support_threshold"));
   EXPECT_EQ(list.setting[4].largest, 0) << "there is no such filter";
   phase_correlation::Config filtered = config;
   filtered.support_threshold = 7;
   const Setting threshold = setting_list(filtered).setting[4];
   EXPECT_EQ(threshold.least, 1);
   EXPECT_EQ(threshold.largest, 35);
   EXPECT_EQ(threshold.start, 7);
   config.left_right_threshold = -1;
   EXPECT_EQ(config.problem().text, std::string("run-time settings need a check or a map of full width"));
}

TEST(PhaseCorrelationConfig, PortsMayLeaveOutAnyDisparityOfAMapOfFullWidth) {
   phase_correlation::Config config = kChecked;
   config.left_right_threshold = -1;
   config.uniqueness_percent = 0;
   config.full_width = true;
   EXPECT_FALSE(config.has_check());
   config.first_disparity = 1;
   EXPECT_TRUE(config.has_check()) << "the last column leads out of the image with what is searched";
   config.first_disparity = 0;
   config.run_time_settings = true;
   EXPECT_TRUE(config.has_check());
   const SettingList list = setting_list(config);
   EXPECT_EQ(list.setting[2].name, std::string("first_disparity"));
   EXPECT_EQ(list.setting[3].largest, 11);
   EXPECT_EQ(list.setting[3].start, 11);
}

/// Also of the rows that the filters wait for.
TEST(PhaseCorrelationConfig, AFrameIsCheckedBeforeTheNextOne) {
   phase_correlation::Config config = kChecked;
   config.run_time_settings = true;
   const auto& codes = config.codes();
   const int groups = codes.transform_groups() * 40 + codes.transform_columns() + codes.groups_behind_transform() + 11 +
                      codes.clocks_to_last_check();
   for (int height = 6; height <= 18; ++height) {
      config.height_px = height;
      EXPECT_EQ(config.problem().empty(), groups < 40 * height) << height;
   }
}

TEST(PhaseCorrelationConfig, ASizeAloneSetsNothingElse) {
   phase_correlation::Config config = kChecked;
   config.run_time_size = true;
   ASSERT_EQ(config.problem().text, std::string());
   const SettingList list = setting_list(config);
   ASSERT_EQ(list.count, 7);
   for (int i = 0; i < 5; ++i) EXPECT_EQ(list.setting[i].largest, 0) << list.setting[i].name;
   EXPECT_EQ(list.setting[5].largest, 40);
   EXPECT_EQ(list.setting[6].largest, 18);
   EXPECT_TRUE(list.setting[5].held && list.setting[6].held);
}

}  // namespace
}  // namespace stereo::test
