// SPDX-License-Identifier: Apache-2.0
#include "trellis/config.hpp"

#include <gtest/gtest.h>

#include <string>

namespace stereo::test {
namespace {

TEST(TrellisConfig, TakesNothingAtRunTime) {
   const trellis::Config good{{.width_px = 40, .height_px = 12}, {.disparities = 12}, {}};
   EXPECT_EQ(good.problem().text, std::string());
   trellis::Config config = good;
   config.run_time_size = true;
   EXPECT_EQ(config.problem().text, std::string("a run-time size is for block matching and semi-global matching"));
   config = good;
   config.run_time_settings = true;
   EXPECT_EQ(config.problem().text, std::string("run-time settings are for block matching and semi-global matching"));
}

}  // namespace
}  // namespace stereo::test
