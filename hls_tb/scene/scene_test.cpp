// SPDX-License-Identifier: Apache-2.0
#include "scene/scene.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <stdexcept>

#include "definition/block_matching/models.hpp"
#include "scene/scene_surfaces.hpp"
#include "testing/seed.hpp"

namespace stereo::test {
namespace {

TEST(Scene, StaysInTheDisparityRangeAtAnySize) {
   for (const auto& [width, height, disparities] :
        {std::array{3, 3, 2}, {9, 3, 8}, {32, 12, 8}, {270, 1, 256}, {5000, 2, 256}, {311, 239, 37}}) {
      const Scene scene =
          make_scene({.width = width, .height = height, .disparities = disparities, .seed = test_seed()});
      for (const GrayImage* image : {&scene.images.left, &scene.images.right, &scene.disparity, &scene.visible,
                                     &scene.left_disparity, &scene.left_visible}) {
         ASSERT_EQ(image->width, width);
         ASSERT_EQ(image->height, height);
      }
      for (const uint8_t disparity : scene.disparity.pixels) ASSERT_LT(disparity, disparities);
      for (const uint8_t disparity : scene.left_disparity.pixels) ASSERT_LT(disparity, disparities);
   }
}

TEST(Scene, VisiblePixelsShowTheSameInBothImages) {
   const Scene scene = make_scene({.seed = test_seed(), .noise = 0});
   int visible = 0, close = 0;
   for (int y = 0; y < scene.disparity.height; ++y)
      for (int x = 0; x < scene.disparity.width; ++x) {
         if (scene.visible.at(x, y) == 0) continue;
         ++visible;
         const int left = scene.images.left.at(x + scene.disparity.at(x, y), y);
         close += std::abs(left - scene.images.right.at(x, y)) <= 24 ? 1 : 0;  // rounded disparities shift the texture
      }
   EXPECT_GT(visible, 640 * 480 / 2);
   EXPECT_GT(100 * close, 95 * visible) << close << " of " << visible;
}

TEST(Scene, VisiblePixelsOfTheLeftImageShowTheSameToo) {
   const Scene scene = make_scene({.seed = test_seed(), .noise = 0});
   int visible = 0, close = 0;
   for (int y = 0; y < scene.left_disparity.height; ++y)
      for (int x = 0; x < scene.left_disparity.width; ++x) {
         if (scene.left_visible.at(x, y) == 0) continue;
         ++visible;
         const int right = scene.images.right.at(x - scene.left_disparity.at(x, y), y);
         close += std::abs(right - scene.images.left.at(x, y)) <= 24 ? 1 : 0;
      }
   EXPECT_GT(visible, 640 * 480 / 2);
   EXPECT_GT(100 * close, 95 * visible) << close << " of " << visible;
}

TEST(Scene, HasDepthAndOcclusions) {
   const Scene scene = make_scene({.seed = test_seed()});
   const std::set<uint8_t> disparities(scene.disparity.pixels.begin(), scene.disparity.pixels.end());
   EXPECT_GT(disparities.size(), 50u);
   int occluded = 0;  // not only out of the left image's sight
   for (int y = 0; y < scene.visible.height; ++y)
      for (int x = 0; x + 100 < scene.visible.width; ++x) occluded += scene.visible.at(x, y) == 0 ? 1 : 0;
   EXPECT_GT(occluded, 1000);
}

TEST(Scene, IsWhatAMatcherFinds) {
   const Scene scene = make_scene({.seed = test_seed()});
   const DisparityMap map = match_fast(scene.images.left, scene.images.right,
                                       block_matching::Matching{DisparityCount{100}, MatchingWindow{7}});
   int visible = 0, good = 0;
   for (int y = 0; y < map.height; ++y)
      for (int x = 0; x < map.width; ++x) {
         if (scene.visible.at(x, y) == 0) continue;
         ++visible;
         good += std::abs(map.at(x, y) - scene.disparity.at(x, y)) <= 1 ? 1 : 0;
      }
   EXPECT_GT(100 * good, 90 * visible) << good << " of " << visible;
}

TEST(Scene, IsWhatAMatcherFindsFromTheLeft) {
   const Scene scene = make_scene({.seed = test_seed()});
   const block_matching::Matching parameters{DisparityCount{100}, MatchingWindow{7}, ReferenceImage{Reference::left},
                                             LeftRightThreshold{1}};
   const DisparityMap map = match_fast(scene.images.left, scene.images.right, parameters);
   const int first = map_first_column(parameters);
   int valid = 0, good = 0, invalid_hidden = 0, hidden = 0;
   for (int y = 0; y < map.height; ++y)
      for (int x = 0; x < map.width; ++x) {
         const bool visible = scene.left_visible.at(first + x, y) != 0;
         hidden += visible ? 0 : 1;
         invalid_hidden += !visible && !map.valid_at(x, y) ? 1 : 0;
         if (!visible || !map.valid_at(x, y)) continue;
         ++valid;
         good += std::abs(map.at(x, y) - scene.left_disparity.at(first + x, y)) <= 1 ? 1 : 0;
      }
   EXPECT_GT(100 * good, 95 * valid) << good << " of " << valid;
   EXPECT_GT(100 * invalid_hidden, 60 * hidden) << "the left/right check finds hidden pixels";
}

TEST(Scene, MovesAndStaysInItsRange) {
   SceneOptions options{.width = 320, .height = 240, .disparities = 64, .seed = test_seed()};
   GrayImage last = make_scene(options).disparity;
   for (options.frame = 1; options.frame < 60; options.frame += options.frame < 12 ? 1 : 7) {
      const Scene scene = make_scene(options);
      for (const uint8_t disparity : scene.disparity.pixels) ASSERT_LT(disparity, options.disparities);
      EXPECT_NE(scene.disparity, last) << "frame " << options.frame;
      last = scene.disparity;
   }
}

TEST(Scene, CarriesItsTextureAlong) {
   Surface object;
   object.shape = Shape::box;
   object.centre_x = 50, object.centre_y = 40, object.half_width = object.half_height = 10;
   Surface later = object;
   later.centre_x += later.moved_x = 7.25;
   later.centre_y += later.moved_y = -3;
   later.growth = 2;
   later.half_width = later.half_height = 20;
   for (int i = 0; i < 20; ++i) {
      const double dx = 0.8 * i - 8, dy = 3 - 0.4 * i;
      ASSERT_NEAR(object.shade(50 + dx, 40 + dy), later.shade(57.25 + 2 * dx, 37 + 2 * dy), 1e-9);
   }
}

TEST(Scene, GetsAnotherObjectNowAndThen) {
   SceneOptions options{.width = 320, .height = 240, .disparities = 64, .seed = test_seed(), .noise = 0};
   const auto changed = [&](int frame) {
      options.frame = frame;
      const GrayImage before = make_scene(options).disparity;
      options.frame = frame + 1;
      const GrayImage after = make_scene(options).disparity;
      int pixels = 0;
      for (std::size_t i = 0; i < before.pixels.size(); ++i)
         pixels += std::abs(before.pixels[i] - after.pixels[i]) > 4 ? 1 : 0;
      return pixels;
   };
   // What drifts changes the map at its edges. A new object changes all pixels that it covers, if it is not hidden.
   int most = 0, usual = 0;
   for (int n = 1; n <= 4; ++n) {
      most = std::max(most, changed(n * kNewObjectFrames - 1));
      usual = std::max(usual, changed(n * kNewObjectFrames + 1));
   }
   EXPECT_GT(most, usual);
}

TEST(Scene, FollowsFromItsOptions) {
   const SceneOptions options{.width = 80, .height = 60, .disparities = 16, .seed = 5};
   EXPECT_EQ(make_scene(options).images.left, make_scene(options).images.left);
   SceneOptions other = options;
   other.seed = 6;
   EXPECT_NE(make_scene(options).images.left, make_scene(other).images.left);
}

TEST(Scene, RejectsOptionsOutOfRange) {
   EXPECT_THROW(make_scene({.width = 16, .disparities = 16}), std::invalid_argument);
   EXPECT_THROW(make_scene({.height = 0}), std::invalid_argument);
   EXPECT_THROW(make_scene({.disparities = 1}), std::invalid_argument);
   EXPECT_THROW(make_scene({.disparities = 257}), std::invalid_argument);
   EXPECT_THROW(make_scene({.noise = -1}), std::invalid_argument);
   EXPECT_THROW(make_scene({.frame = -1}), std::invalid_argument);
   EXPECT_THROW(make_scene({.frame = 65536}), std::invalid_argument);
}

}  // namespace
}  // namespace stereo::test
