// SPDX-License-Identifier: Apache-2.0
#include "program/postprocessing/postprocessing.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <opencv2/calib3d.hpp>
#include <opencv2/ximgproc/disparity_filter.hpp>

#include "definition/block_matching/models.hpp"
#include "definition/mirror.hpp"
#include "program/postprocessing/confidence.hpp"
#include "program/postprocessing/speckles.hpp"
#include "scene/random.hpp"
#include "scene/scene.hpp"
#include "testing/by_hand.hpp"
#include "testing/map_compare.hpp"
#include "testing/seed.hpp"

namespace stereo::app {
namespace {

using test::test_seed;
constexpr int kInvalid = -16;  ///< to OpenCV

/// Steps and noise of some sixteenths, and some invalid pixels.
DisparityMap rough_map(int width, int height, Random& random, int noise, int invalid_percent) {
   DisparityMap map(width, height, 0, true);
   for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) {
         map.at(x, y) = uint16_t(16 * 4 + 16 * ((x / 9 + y / 7) % 3) + random.below(noise));
         map.valid_at(x, y) = random.percent(invalid_percent) ? 0 : 1;
      }
   return map;
}

cv::Mat_<short> as_opencv(const DisparityMap& map, int sign = 1) {
   cv::Mat_<short> mat(map.height, map.width);
   for (int y = 0; y < map.height; ++y)
      for (int x = 0; x < map.width; ++x) mat(y, x) = short(map.valid_at(x, y) ? sign * map.at(x, y) : kInvalid);
   return mat;
}

TEST(Speckles, AreSetsOfAtMostSoManyJoinedPixels) {
   DisparityMap map = test::map(5, 3,
                                {5, 5, 5, 9, 5,  //
                                 5, 7, 5, 9, 5,  //
                                 5, 5, 5, 9, 6});
   map.valid_at(4, 0) = 0;
   const auto valid_after = [&](int window_px, int range_px) {
      DisparityMap copy = map;
      remove_speckles(copy, window_px, range_px);
      EXPECT_EQ(copy.disparity, map.disparity);
      return copy.valid;
   };
   using Valid = std::vector<uint8_t>;
   EXPECT_EQ(valid_after(1, 1), (Valid{1, 1, 1, 1, 0, 1, 0, 1, 1, 1, 1, 1, 1, 1, 1})) << "the 7 alone";
   EXPECT_EQ(valid_after(2, 1), (Valid{1, 1, 1, 1, 0, 1, 0, 1, 1, 0, 1, 1, 1, 1, 0})) << "5 and 6 are joined";
   EXPECT_EQ(valid_after(2, 0), (Valid{1, 1, 1, 1, 0, 1, 0, 1, 1, 0, 1, 1, 1, 1, 0})) << "and each alone";
   EXPECT_EQ(valid_after(1, 0), (Valid{1, 1, 1, 1, 0, 1, 0, 1, 1, 0, 1, 1, 1, 1, 0}));
   EXPECT_EQ(valid_after(3, 1), (Valid{1, 1, 1, 0, 0, 1, 0, 1, 0, 0, 1, 1, 1, 0, 0}));
   EXPECT_EQ(valid_after(1, 2), (Valid{1, 1, 1, 1, 0, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1}));
}

TEST(Speckles, AreThoseOfOpenCv) {
   Random random(test_seed());
   for (const auto& [width, height] : {std::pair{60, 40}, {1, 30}, {30, 1}, {1, 1}})
      for (const int window_px : {1, 3, 20, 400})
         for (const int range_px : {0, 1, 2}) {
            DisparityMap map = rough_map(width, height, random, 40, 20);
            cv::Mat_<short> wanted = as_opencv(map);
            cv::filterSpeckles(wanted, kInvalid, window_px, 16 * range_px);
            remove_speckles(map, window_px, range_px);
            EXPECT_EQ(cv::countNonZero(as_opencv(map) != wanted), 0)
                << width << 'x' << height << ", " << window_px << " pixels, range " << range_px;
         }
}

TEST(Speckles, HaveFilledPixelsLikeMeasuredOnes) {
   Random random(test_seed());
   for (const int window_px : {1, 3, 20, 400}) {
      DisparityMap map = rough_map(60, 40, random, 40, 20);
      for (const uint8_t valid : map.valid) map.filled.push_back(valid == 0 && random.percent(60) ? 1 : 0);
      DisparityMap shown = map;
      for (std::size_t i = 0; i < map.valid.size(); ++i) shown.valid[i] |= map.filled[i];
      const DisparityMap before = map;
      remove_speckles(map, window_px, 1);
      remove_speckles(shown, window_px, 1);
      for (std::size_t i = 0; i < map.valid.size(); ++i) {
         EXPECT_EQ(map.valid[i] | map.filled[i], shown.valid[i]) << "window " << window_px << ", pixel " << i;
         EXPECT_LE(map.filled[i], before.filled[i]);
      }
   }
}

TEST(Confidence, IsThatOfOpenCv) {
   Random random(test_seed());
   constexpr int kWidth = 90, kHeight = 50;
   const MapGeometry geometry{Reference::left, 0, kWidth, 16, 0, false};
   for (const int noise : {1, 12, 30}) {
      const DisparityMap left = rough_map(kWidth, kHeight, random, noise, 0);
      const DisparityMap right = rough_map(kWidth, kHeight, random, noise, 0);
      const auto opencv = cv::ximgproc::createDisparityWLSFilterGeneric(true);
      const cv::Mat view(kHeight, kWidth, CV_8UC1, cv::Scalar(128));
      cv::Mat filtered;
      opencv->filter(as_opencv(left), view, filtered, as_opencv(right, -1), cv::Rect(0, 0, kWidth, kHeight));
      const cv::Mat wanted = opencv->getConfidenceMap();
      const GrayImage found = confidence(left, right, geometry, kWidth);
      int positive = 0;
      // OpenCV's windows at the border hold mirrored pixels, ours none; the partners stand up to 10 columns further
      // left.
      for (int y = kConfidenceRadius; y < kHeight - kConfidenceRadius; ++y)
         for (int x = kConfidenceRadius + 10; x < kWidth - kConfidenceRadius; ++x) {
            EXPECT_NEAR(wanted.at<float>(y, x), float(found.at(x, y)) + 0.5F, 0.6F) << x << ", " << y;
            positive += found.at(x, y) > 0 ? 1 : 0;
         }
      EXPECT_GT(positive, 200);
   }
}

TEST(Confidence, LessWhereDisparitiesDiffer) {
   DisparityMap map(30, 1, 3);
   for (int x = 15; x < 30; ++x) map.at(x, 0) = 4;
   const GrayImage smooth = smoothness(map);
   EXPECT_EQ(smooth.at(9, 0), 255);
   // Of 11 pixels 1, 5 or 6 differ by 16 sixteenths: variances of 256 * 10/121 and 256 * 30/121.
   EXPECT_EQ(smooth.at(10, 0), int(255 * (1 - 0.256 * 10 / 121)));
   EXPECT_EQ(smooth.at(14, 0), int(255 * (1 - 0.256 * 30 / 121)));
   EXPECT_EQ(smooth.at(15, 0), smooth.at(14, 0));
   for (int x = 15; x < 30; ++x) map.at(x, 0) = 9;
   EXPECT_EQ(smoothness(map).at(14, 0), 0);
   EXPECT_EQ(smoothness(map).at(29, 0), 255);
}

TEST(Confidence, NoneWithoutAPartnerThatAgrees) {
   const MapGeometry geometry{
       Reference::right, 0, 20, 8, 2, false};  // the left image's map stands at its columns 10 ... 29
   const DisparityMap map(20, 1, 3);
   DisparityMap other(20, 1, 3);
   other.valid_at(5, 0) = 0;  // of column 10: 10 + 2 + 3 = 10 + 5
   const GrayImage found = confidence(map, other, geometry, 30);
   for (int x = 0; x < 20; ++x) EXPECT_EQ(found.at(x, 0), x < 5 || x == 10 ? 0 : 255) << x;
   const auto at_11 = [&](int disparity) {
      DisparityMap odd(20, 1, 3);
      odd.at(6, 0) = uint16_t(disparity);
      return confidence(map, odd, geometry, 30).at(11, 0);
   };
   EXPECT_GT(at_11(4), 0) << "16 sixteenths";
   EXPECT_GT(at_11(2), 0);
   EXPECT_EQ(at_11(5), 0) << "32 sixteenths";
}

/// Block matching of either reference: the other image's map is the one that the other reference gives.
TEST(Confidence, TheOtherMapIsThatOfTheOtherReference) {
   const ImagePair pair = make_scene({.width = 80, .height = 24, .disparities = 12, .seed = test_seed()}).images;
   block_matching::Matching matching{DisparityCount{12}, MatchingWindow{3}, SubpixelSteps{true}};
   const auto match = [&](const ImagePair& images) {
      return block_matching::match_reference(images.left, images.right, matching);
   };
   const DisparityMap other = other_map(match, pair);
   matching.reference = Reference::left;
   EXPECT_TRUE(test::same_map(match(pair), other));
}

TEST(Postprocessing, DoesWhatIsOn) {
   const ImagePair pair = make_scene({.width = 80, .height = 40, .disparities = 12, .seed = test_seed()}).images;
   const block_matching::Matching matching{DisparityCount{12}, MatchingWindow{5}};
   const MapGeometry geometry = map_geometry(matching, pair.left.width);
   int runs = 0;
   const auto match = [&](const ImagePair& images) {
      ++runs;
      return block_matching::match_reference(images.left, images.right, matching);
   };
   const ProcessedMap plain = match_and_process(match, pair, geometry, {});
   EXPECT_FALSE(plain.confidence);
   EXPECT_EQ(runs, 1);
   const ProcessedMap shown = match_and_process(match, pair, geometry, {.wants_confidence = true});
   EXPECT_EQ(shown.map, plain.map);
   EXPECT_EQ(runs, 3);
   const ProcessedMap strict = match_and_process(match, pair, geometry, {.least_confidence = 200});
   ASSERT_TRUE(shown.confidence && strict.confidence);
   EXPECT_EQ(*strict.confidence, *shown.confidence);
   DisparityMap wanted = plain.map;
   for (std::size_t i = 0; i < wanted.valid.size(); ++i) wanted.valid[i] = shown.confidence->pixels[i] >= 200 ? 1 : 0;
   EXPECT_EQ(strict.map, wanted);
   EXPECT_NE(strict.map, plain.map);
   remove_speckles(wanted, 300, 1);
   EXPECT_EQ(match_and_process(match, pair, geometry, {.speckle_window_px = 300, .least_confidence = 200}).map, wanted);
   EXPECT_NE(wanted, strict.map) << "the speckles are sought in what the confidence left";
}

TEST(Postprocessing, TakesThePercentOfTheCountedPixels) {
   // Sure pixels above, a ramp below; only the ramp counts.
   DisparityMap map(10, 20);
   map.valid.assign(map.valid.size(), 1);
   map.confidence.assign(map.valid.size(), 255);
   GrayImage counted(map.width, map.height);
   for (int i = 0; i < 100; ++i) {
      map.confidence[std::size_t(100 + i)] = uint8_t(1 + i);
      counted.pixels[std::size_t(100 + i)] = 255;
   }
   const ImagePair pair{GrayImage(10, 20), GrayImage(10, 20)};
   const auto match = [&](const ImagePair&) { return map; };
   const auto left_over = [&](const GrayImage* pixels) {
      const Postprocessing options{.surest_percent = 30, .counted = pixels};
      const DisparityMap found = match_and_process(match, pair, MapGeometry{}, options).map;
      return std::count(found.valid.begin(), found.valid.end(), uint8_t(1));
   };
   EXPECT_EQ(left_over(&counted), 100 + 30);
   EXPECT_EQ(left_over(nullptr), 100) << "of all pixels those above are half";
}

}  // namespace
}  // namespace stereo::app
