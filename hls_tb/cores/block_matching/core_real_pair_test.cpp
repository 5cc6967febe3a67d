// SPDX-License-Identifier: Apache-2.0
// The whole core and the reference on a picture of the world.
#include <cmath>
#include <cstdlib>

#include "block_matching/config.hpp"
#include "program/io/images.hpp"
#include "testing/expect_reference.hpp"
#include "testing/teddy.hpp"

namespace stereo::test {
namespace {

inline constexpr block_matching::Config kTeddy{
    {.width_px = 450, .height_px = 375}, {DisparityCount{60}, MatchingWindow{5}}, {}};
/// Its rows as far as they fill groups of four.
inline constexpr block_matching::Config kTeddyTop{
    {.width_px = 450, .height_px = 372, .pixels_per_clock = 4}, {DisparityCount{60}, MatchingWindow{5}}, {}};

GrayImage top_rows(GrayImage image, int height) {
   image.height = height;
   image.pixels.resize(std::size_t(image.width) * std::size_t(height));
   return image;
}

TEST(StereoCore, EqualsTheReferenceOnARealPair) {
   const std::filesystem::path folder = teddy_folder();
   if (folder.empty()) GTEST_SKIP() << kNoTeddy;
   const ImagePair pair = app::load_pair(folder / "left.png", folder / "right.png");
   expect_reference<kTeddy>(pair);
   expect_reference<kTeddyTop>({top_rows(pair.left, kTeddyTop.height_px), top_rows(pair.right, kTeddyTop.height_px)});

   // The truth, four times the disparity and 0 where unknown: most pixels must be right within one.
   const GrayImage truth = app::load_gray(folder / "disp_right_x4.pgm");
   const DisparityMap map = reference_map(pair, kTeddy);
   int known = 0, good = 0;
   for (int y = 0; y < map.height; ++y)
      for (int x = 0; x < map.width; ++x) {
         if (truth.at(x, y) == 0) continue;
         ++known;
         good += std::abs(4 * map.at(x, y) - truth.at(x, y)) <= 4 ? 1 : 0;
      }
   RecordProperty("good_percent", 100 * good / known);
   EXPECT_GT(100 * good, 60 * known) << good << " of " << known << " pixels";
}

}  // namespace
}  // namespace stereo::test
