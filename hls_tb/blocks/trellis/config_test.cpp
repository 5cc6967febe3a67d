// SPDX-License-Identifier: Apache-2.0
#include "trellis/config.hpp"

#include <gtest/gtest.h>

#include <string>

#include "trellis/settings.hpp"

namespace stereo::test {
namespace {

constexpr trellis::Config kGood{{.width_px = 40, .height_px = 12}, {DisparityCount{12}}, {}};

TEST(TrellisConfig, SettingsGoUpToTheConfigurations) {
   trellis::Config config = kGood;
   config.drop_cost = 4;
   config.occlusion_cost = 9;
   config.run_time_settings = true;
   ASSERT_EQ(config.problem().text, std::string());
   const SettingList list = setting_list(config);
   ASSERT_EQ(list.count, 3);
   EXPECT_EQ(list.setting[0].name, std::string("drop_cost"));
   EXPECT_EQ(list.setting[0].least, 0);
   EXPECT_EQ(list.setting[0].largest, 4);
   EXPECT_EQ(list.setting[0].start, 4);
   EXPECT_EQ(list.setting[1].name, std::string("occlusion_cost"));
   EXPECT_EQ(list.setting[1].least, 1);
   EXPECT_EQ(list.setting[1].largest, 9);
   EXPECT_EQ(list.setting[1].start, 9);
   EXPECT_EQ(list.setting[2].name, std::string("support_threshold"));
   EXPECT_EQ(list.setting[2].largest, 0) << "there is no such filter";
}

TEST(TrellisConfig, AFrameIsThereBeforeTheNextOne) {
   trellis::Config config = kGood;
   config.run_time_settings = true;
   for (int height = 5; height <= 12; ++height) {
      config.height_px = height;
      const int groups = config.costs().windows().groups_to_first_window() + config.clocks_to_forward();
      EXPECT_EQ(config.problem().empty(), groups < 40 * height) << height;
   }
   config.height_px = 5;
   EXPECT_EQ(config.problem().text,
             std::string("with run-time settings the image must be higher, for a frame's first column to be there "
                         "before the next one"));
}

TEST(TrellisConfig, IsNotFolded) {
   trellis::Config config = kGood;
   config.clocks_per_pixel = 4;
   EXPECT_EQ(config.problem().text, std::string("the trellis takes a pixel pair a clock"));
   config.clocks_per_pixel = 1;
   config.front_clocks = 2;
   EXPECT_FALSE(config.problem().empty());
}

TEST(TrellisConfig, ASizeAloneSetsNothingElse) {
   trellis::Config config = kGood;
   config.run_time_size = true;
   ASSERT_EQ(config.problem().text, std::string());
   const SettingList list = setting_list(config);
   ASSERT_EQ(list.count, 5);
   for (int i = 0; i < 3; ++i) EXPECT_EQ(list.setting[i].largest, 0) << list.setting[i].name;
   EXPECT_EQ(list.setting[1].least, 0);
   EXPECT_EQ(list.setting[3].name, std::string("image_width"));
   EXPECT_EQ(list.setting[3].largest, 40);
   EXPECT_EQ(list.setting[4].name, std::string("image_height"));
   EXPECT_EQ(list.setting[4].largest, 12);
}

}  // namespace
}  // namespace stereo::test
