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
   EXPECT_EQ(C.largest_sad(), 9 * 255);
}

TEST(StereoConfig, RadiusIsHalfTheWindow) {
   EXPECT_EQ(kSmallest.radius_px(), 1);
   EXPECT_EQ(kFive.radius_px(), 2);
}

TEST(ConfigurationTable, FindsEveryNameAndNoOther) {
   std::set<std::string> names;
   for (const Configuration& entry : configuration_table()) {
      EXPECT_EQ(find_configuration(entry.name), &entry);
      EXPECT_TRUE(names.insert(entry.name).second) << entry.name << " stands there twice";
   }
   EXPECT_TRUE(names.contains("ambrosch2007"));
   EXPECT_TRUE(names.contains("tiny"));
   EXPECT_EQ(find_configuration("no such configuration"), nullptr);
}

}  // namespace
}  // namespace stereo::test
