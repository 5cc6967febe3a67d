// SPDX-License-Identifier: Apache-2.0
#include "rectification/config.hpp"

#include <gtest/gtest.h>

#include <string>

namespace stereo::test {
namespace {

using rectification::Config;

std::string problem(const Config& config) { return config.problem().text; }

TEST(RectificationConfig, SaysWhyACoreCannotBeBuilt) {
   const Config fits{{.width_px = 640, .height_px = 480}, {}};
   EXPECT_EQ(problem(fits), "");
   const auto refused = [&fits](int Config::*option, int value, const std::string& words) {
      Config config = fits;
      config.*option = value;
      EXPECT_NE(problem(config).find(words), std::string::npos) << problem(config);
   };
   refused(&Config::width_px, 4097, "the image width is 4097");
   for (const int bits : {10, 12}) {
      Config deep = fits;
      deep.pixel_bits = bits;
      EXPECT_EQ(problem(deep), "");
   }
   refused(&Config::pixel_bits, 9, "bits of a pixel is 9 but must be 8, 10 or 12");
   refused(&Config::pixel_bits, 11, "bits of a pixel is 11 but must be 8, 10 or 12");
   refused(&Config::pixel_bits, 14, "bits of a pixel is 14 but must be 8 ... 12");
   refused(&Config::pixels_per_clock, 2, "one pixel pair a clock");
   refused(&Config::grid_px, 12, "nodes is 12 but must be a power of two");
   refused(&Config::grid_px, 128, "nodes is 128 but must be 4 ... 64");
   refused(&Config::offset_bits, 17, "bits of an offset is 17 but must be 8 ... 16");
   refused(&Config::offset_fraction_bits, 3, "fraction bits of an offset is 3");
   EXPECT_NE(problem({fits, {.offset_bits = 8, .offset_fraction_bits = 8}}).find("more bits than fraction bits"),
             std::string::npos);
   refused(&Config::weight_bits, 9, "bits of the weights is 9");
   refused(&Config::rows_above, 256, "rows above is 256");
   refused(&Config::rows_below, -1, "rows below is -1");
   refused(&Config::height_px, 17, "height is 17 but must be above the number of rows below plus 1, which is 17");
}

TEST(RectificationConfig, RefusesMoreRowsThanAnAddressReaches) {
   Config config{{.width_px = 4094, .height_px = 480}, {.rows_above = 31, .rows_below = 31}};
   EXPECT_EQ(config.buffered_columns() * config.buffered_rows() / 4, 1 << 16);
   EXPECT_EQ(problem(config), "");
   config.width_px = 4096;
   EXPECT_NE(problem(config).find("more words"), std::string::npos) << problem(config);
}

TEST(RectificationConfig, CountsNodesAndRows) {
   const Config config{{.width_px = 640, .height_px = 480}, {.grid_px = 16, .rows_above = 12, .rows_below = 9}};
   EXPECT_EQ(config.table_columns(), 41) << "at 0, 16 ... 640";
   EXPECT_EQ(config.table_rows(), 31);
   EXPECT_EQ(config.table_bits(640, 480), 41 * 31 * 32);
   EXPECT_EQ(config.lag_rows(), 10);
   EXPECT_EQ(config.buffered_rows(), 24) << "12 above, its own, 9 below, the one that comes in: 23";
   EXPECT_EQ(config.buffered_columns(), 642);
}

}  // namespace
}  // namespace stereo::test
