// SPDX-License-Identifier: Apache-2.0
// The reference model beside OpenCV's StereoBM and median filter: "Beside OpenCV's StereoBM" in docs/algorithm.md.
#include <algorithm>

#include <gtest/gtest.h>

#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>

#include "definition/block_matching/matching_input.hpp"
#include "definition/block_matching/reference_model.hpp"
#include "program/io/images.hpp"
#include "scene/random.hpp"
#include "scene/scene.hpp"
#include "testing/map_compare.hpp"
#include "testing/seed.hpp"
#include "testing/teddy.hpp"
#include "testing/test_pairs.hpp"

namespace stereo::block_matching {
namespace {

using namespace test;

DisparityMap random_map(int width, int height, int limit, uint64_t seed) {
   Random random(seed);
   DisparityMap map(width, height);
   for (uint16_t& disparity : map.disparity) disparity = uint16_t(random.below(limit));
   return map;
}

/// Elem: the type of OpenCV's pixels.
template <class Elem>
DisparityMap opencv_median(const DisparityMap& map) {
   cv::Mat_<Elem> in(map.height, map.width), out;
   std::copy(map.disparity.begin(), map.disparity.end(), in.begin());
   cv::medianBlur(in, out, 3);
   DisparityMap result = map;
   std::copy(out.begin(), out.end(), result.disparity.begin());
   return result;
}

TEST(OpenCv, MedianIsTheSame) {
   for (const auto& [width, height] : {std::pair{40, 30}, {1, 9}, {9, 1}, {1, 1}, {2, 2}, {311, 7}})
      for (const int limit : {3, 256}) {
         const DisparityMap map = random_map(width, height, limit, test_seed());
         EXPECT_TRUE(same_map(opencv_median<uint8_t>(map), median_filtered(map))) << width << 'x' << height;
      }
   for (const auto& [width, height] : {std::pair{40, 30}, {1, 9}, {9, 1}, {2, 2}}) {
      const DisparityMap map = random_map(width, height, 4096, test_seed());
      EXPECT_TRUE(same_map(opencv_median<uint16_t>(map), median_filtered(map))) << width << 'x' << height;
   }
}

struct BmOptions {
   int disparities = 64;
   int window_px = 15;
   int uniqueness_percent = 15;
   int texture_threshold = 10;
   int min_disparity = 0;
   int cap = 31;
};

/// As StereoBM matches: ties to the largest disparity, the left image as reference.
block_matching::Matching like_stereo_bm(const BmOptions& options) {
   return {DisparityCount{options.disparities},
           MatchingWindow{options.window_px},
           SmallestDisparity{options.min_disparity},
           ReferenceImage{Reference::left},
           Prefiltering{.prefilter = Prefilter::xsobel, .prefilter_cap = options.cap},
           TieRule{Ties::largest},
           UniquenessPercent{options.uniqueness_percent},
           TextureThreshold{options.texture_threshold},
           SubpixelSteps{true}};
}

cv::Mat_<short> stereo_bm(const ImagePair& pair, const BmOptions& options) {
   ImagePair copy = pair;
   const cv::Mat left(copy.left.height, copy.left.width, CV_8U, copy.left.pixels.data());
   const cv::Mat right(copy.right.height, copy.right.width, CV_8U, copy.right.pixels.data());
   const cv::Ptr<cv::StereoBM> matcher = cv::StereoBM::create(options.disparities, options.window_px);
   matcher->setPreFilterType(cv::StereoBM::PREFILTER_XSOBEL);
   matcher->setPreFilterCap(options.cap);
   matcher->setUniquenessRatio(options.uniqueness_percent);
   matcher->setTextureThreshold(options.texture_threshold);
   matcher->setMinDisparity(options.min_disparity);
   cv::Mat_<short> map;
   matcher->compute(left, right, map);
   return map;
}

struct Differences {
   int compared = 0, valid = 0, differing = 0;
   int first_x = -1, first_y = -1;  ///< of those that differ
};

/// Over the pixels whose windows lie in the images for every disparity: the others StereoBM leaves invalid.
Differences compare_inside(const ImagePair& pair, const BmOptions& options) {
   const cv::Mat_<short> theirs = stereo_bm(pair, options);
   const block_matching::Matching parameters = like_stereo_bm(options);
   const DisparityMap ours = match_reference(pair.left, pair.right, parameters);
   const int radius = options.window_px / 2, m = options.min_disparity, first = map_first_column(parameters);
   Differences result;
   for (int y = radius; y < pair.left.height - radius; ++y)
      for (int x = std::max(0, m + options.disparities - 1) + radius;
           x < std::min(pair.left.width, pair.left.width + m) - radius; ++x) {
         const int column = x - first;
         const bool valid = ours.valid_at(column, y);
         const int expected = theirs(y, x), got = valid ? ours.at(column, y) + 16 * m : 16 * (m - 1);
         ++result.compared;
         result.valid += valid ? 1 : 0;
         if (expected == got) continue;
         if (++result.differing > 1) continue;
         result.first_x = x;
         result.first_y = y;
      }
   return result;
}

/// Returns how many percent of the compared pixels are valid.
int expect_same(const ImagePair& pair, const BmOptions& options) {
   const Differences result = compare_inside(pair, options);
   EXPECT_GT(result.compared, 0);
   EXPECT_EQ(result.differing, 0) << "of " << result.compared << ", first x=" << result.first_x
                                  << " y=" << result.first_y << "; D=" << options.disparities
                                  << " B=" << options.window_px << " uniqueness=" << options.uniqueness_percent
                                  << " texture=" << options.texture_threshold << " m=" << options.min_disparity
                                  << " cap=" << options.cap;
   return 100 * result.valid / std::max(result.compared, 1);
}

const BmOptions kSomeOptions[] = {{},
                                  {.uniqueness_percent = 0, .texture_threshold = 0},
                                  {.window_px = 5},
                                  {.window_px = 9, .uniqueness_percent = 5, .texture_threshold = 300},
                                  {.window_px = 21, .uniqueness_percent = 10, .texture_threshold = 1000},
                                  {.disparities = 16, .window_px = 7, .uniqueness_percent = 40},
                                  {.disparities = 96, .window_px = 11},
                                  {.min_disparity = 8},
                                  {.min_disparity = -20},
                                  {.window_px = 23},
                                  {.window_px = 9, .cap = 63},
                                  {.window_px = 13, .cap = 5}};

ImagePair even_rows(ImagePair pair) {
   for (GrayImage* const image : {&pair.left, &pair.right}) {
      image->height -= image->height % 2;
      image->pixels.resize(std::size_t(image->width) * std::size_t(image->height));
   }
   return pair;
}

TEST(OpenCv, StereoBmIsTheSameOnScenes) {
   for (const uint64_t seed : {test_seed(), test_seed() + 1}) {
      const ImagePair pair = make_scene({.width = 256, .height = 120, .disparities = 64, .seed = seed}).images;
      for (const BmOptions& options : kSomeOptions) expect_same(pair, options);
      const int valid_percent = expect_same(pair, {});
      EXPECT_GT(valid_percent, 30);
      EXPECT_LT(valid_percent, 100);
   }
}

TEST(OpenCv, StereoBmIsTheSameOnImagesFullOfTies) {
   for (const BmOptions& options : kSomeOptions) {
      expect_same({GrayImage(200, 60, 90), GrayImage(200, 60, 90)}, options);
      for (const int levels : {2, 3, 256}) expect_same(random_pair(200, 60, test_seed(), levels), options);
      for (const NamedPair& named : test_pairs(180, 50, 16, test_seed())) {
         SCOPED_TRACE(named.name);
         expect_same(named.images, options);
      }
   }
}

TEST(OpenCv, StereoBmIsTheSameOnARealPair) {
   const std::filesystem::path folder = teddy_folder();
   if (folder.empty()) GTEST_SKIP() << kNoTeddy;
   const ImagePair pair = even_rows(app::load_pair(folder / "left.png", folder / "right.png"));
   for (const BmOptions& options : kSomeOptions) expect_same(pair, options);
   EXPECT_GT(expect_same(pair, {}), 80) << "percent of the pixels are valid";
}

// White and black ramps against each other: every filtered difference is the largest there is.
TEST(OpenCv, StereoBmIsTheSameAtTheLargestCosts) {
   ImagePair ramps{GrayImage(64, 60), GrayImage(64, 60)};
   for (int y = 0; y < 60; ++y)
      for (int x = 0; x < 64; ++x) {
         ramps.left.at(x, y) = uint8_t(4 * x);
         ramps.right.at(x, y) = uint8_t(252 - 4 * x);
      }
   for (const int percent : {0, 15, 50, 100})
      expect_same(ramps, {.disparities = 16, .window_px = 21, .uniqueness_percent = percent});
}

TEST(OpenCv, StereoBmIsTheSameWithDisparitiesFarFromZero) {
   for (const int min_disparity : {-120, -80, -64, -63, 60, 100})
      expect_same(random_pair(250, 60, test_seed(), 4), {.uniqueness_percent = 3, .min_disparity = min_disparity});
}

TEST(OpenCv, StereoBmLeavesTheLastOfAnOddNumberOfRowsUnfiltered) {
   for (const int window : {5, 15}) {
      const BmOptions options{.window_px = window, .uniqueness_percent = 0, .texture_threshold = 0};
      const Differences odd = compare_inside(random_pair(200, 61, test_seed()), options);
      EXPECT_GT(odd.differing, 0) << "OpenCV has changed: docs/algorithm.md says that these differ";
      EXPECT_EQ(odd.first_y, 60 - window / 2) << "only windows that reach the last row differ";
   }
}

}  // namespace
}  // namespace stereo::block_matching
