// SPDX-License-Identifier: Apache-2.0
// The definition of docs/rectification.md on cases whose result is known without it.
#include "definition/rectification/reference_model.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <stdexcept>

#include "scene/random.hpp"
#include "testing/seed.hpp"

namespace stereo::rectification {
namespace {

using test::test_seed;

DeepImage random_deep_image(int width, int height, int bits, Random& random) {
   DeepImage image(width, height);
   for (uint16_t& pixel : image.pixels) pixel = uint16_t(random.below(1 << bits));
   return image;
}

GrayImage random_image(int width, int height, Random& random) {
   GrayImage image(width, height);
   for (uint8_t& pixel : image.pixels) pixel = random.byte();
   return image;
}

template <class Image>
Table shift(const Warp& warp, const Image& image, Offset offset) {
   Table table(warp, image.width, image.height);
   for (Offset& node : table.nodes) node = offset;
   return table;
}

TEST(Rectification, LeavesAnImageAsItIsWhereAllOffsetsAre0) {
   Random random(test_seed());
   for (const int grid : {4, 8, 16, 32, 64}) {
      const Warp warp{.grid_px = grid, .rows_above = 0, .rows_below = 0};
      const GrayImage image = random_image(37, 21, random);
      EXPECT_EQ(rectified(image, shift(warp, image, {0, 0}), warp), image) << grid;
   }
}

TEST(Rectification, MovesByWholePixelsAndIs0Outside) {
   Random random(test_seed());
   const Warp warp;
   const GrayImage image = random_image(37, 21, random);
   for (const Offset& offset : {Offset{3, 2}, {-5, 4}, {0, -7}, {40, 0}}) {
      const GrayImage moved = rectified(image, shift(warp, image, {offset.x * 64, offset.y * 64}), warp);
      for (int y = 0; y < image.height; ++y)
         for (int x = 0; x < image.width; ++x) {
            const int column = x + offset.x, row = y + offset.y;
            const bool inside = column >= 0 && column < image.width && row >= 0 && row < image.height;
            ASSERT_EQ(moved.at(x, y), inside ? image.at(column, row) : 0) << x << ' ' << y;
         }
   }
}

TEST(Rectification, WeighsFourPixelsAndRoundsHalvesUp) {
   const Warp warp;
   GrayImage image(8, 2);
   image.at(3, 0) = 100;
   image.at(4, 0) = 101;
   image.at(3, 1) = 40;
   image.at(4, 1) = 40;
   EXPECT_EQ(rectified(image, shift(warp, image, {32, 0}), warp).at(3, 0), 101) << "100.5";
   EXPECT_EQ(rectified(image, shift(warp, image, {0, 16}), warp).at(3, 0), 85) << "3/4 of 100 and 1/4 of 40";
   EXPECT_EQ(rectified(image, shift(warp, image, {32, 32}), warp).at(3, 0), 70) << "70.25";
   EXPECT_EQ(rectified(image, shift(warp, image, {0, -32}), warp).at(4, 0), 51) << "half of 101: above is nothing";
}

TEST(Rectification, LeavesAnImageOfMoreBitsAsItIsWhereAllOffsetsAre0) {
   Random random(test_seed());
   for (const int bits : {8, 10, 12}) {
      const Warp warp{.pixel_bits = bits};
      const DeepImage image = random_deep_image(37, 21, bits, random);
      EXPECT_EQ(rectified(image, shift(warp, image, {0, 0}), warp), image) << bits;
   }
}

TEST(Rectification, RoundsPixelsOf12BitsToTheirLowestBit) {
   const Warp warp{.pixel_bits = 12};
   DeepImage image(8, 2);
   image.at(3, 0) = 4095;
   image.at(4, 0) = 4094;
   image.at(3, 1) = 1;
   EXPECT_EQ(rectified(image, shift(warp, image, {32, 0}), warp).at(3, 0), 4095) << "4094.5";
   EXPECT_EQ(rectified(image, shift(warp, image, {0, 32}), warp).at(3, 0), 2048) << "half of 4095 and of 1";
   EXPECT_EQ(rectified(image, shift(warp, image, {0, -32}), warp).at(4, 0), 2047) << "half of 4094: above is nothing";
   const DeepImage white(8, 8, 4095);
   EXPECT_EQ(rectified(white, shift(warp, white, {17, 43}), warp).at(3, 3), 4095) << "all four are the largest one";
}

/// 16 times the grey values: the same sums, and only the rounding is finer.
TEST(Rectification, Of12BitsIsThatOf8BitsButForTheRounding) {
   Random random(test_seed());
   const Warp warp{.grid_px = 8}, deep_warp{.pixel_bits = 12, .grid_px = 8};
   const GrayImage image = random_image(40, 30, random);
   DeepImage deep = widened(image);
   for (uint16_t& pixel : deep.pixels) pixel = uint16_t(16 * pixel);
   Table table(warp, image.width, image.height);
   for (Offset& node : table.nodes) node = {random.below(512) - 256, random.below(512) - 256};
   const GrayImage made = rectified(image, table, warp);
   const DeepImage made_deep = rectified(deep, table, deep_warp);
   int finer = 0;
   for (std::size_t i = 0; i < made.pixels.size(); ++i) {
      const int difference = made_deep.pixels[i] - 16 * made.pixels[i];
      ASSERT_LE(std::abs(2 * difference), 16) << i;
      finer += difference != 0 ? 1 : 0;
   }
   EXPECT_GT(finer, 1000) << "of 1200";
}

TEST(Rectification, InterpolatesBetweenTheNodes) {
   const Warp warp{.grid_px = 4, .offset_fraction_bits = 8, .weight_bits = 8};
   Table table(warp, 8, 8);
   table.at(0, 0) = {0, 1024};
   table.at(1, 0) = {256, 1024};
   table.at(0, 1) = {-256, 1024};
   table.at(1, 1) = {512, 2048};
   EXPECT_EQ(source_place(table, warp, 0, 0).x, 0);
   EXPECT_EQ(source_place(table, warp, 1, 0).x, 256 + 64);
   EXPECT_EQ(source_place(table, warp, 0, 2).x, -128);
   EXPECT_EQ(source_place(table, warp, 2, 2).x, 512 + 128) << "the mean of the four";
   EXPECT_EQ(source_place(table, warp, 2, 2).y, 512 + 1024 + 256);
}

TEST(Rectification, RoundsPlacesToTheNearest) {
   const Warp warp{.grid_px = 4, .offset_fraction_bits = 4, .weight_bits = 1};
   const auto place = [&](int offset) {
      Table table(warp, 8, 8);
      for (Offset& node : table.nodes) node = {offset, 0};
      return source_place(table, warp, 0, 0).x;
   };
   EXPECT_EQ(place(3), 0);
   EXPECT_EQ(place(4), 1) << "a half goes up";
   EXPECT_EQ(place(-4), 0);
   EXPECT_EQ(place(-5), -1);
}

TEST(Rectification, CountsTapsOutsideTheKeptRowsAs0) {
   const Warp warp{.rows_above = 2, .rows_below = 3};
   const GrayImage image(10, 20, 200);
   const auto middle = [&](int rows_in_64ths) {
      return rectified(image, shift(warp, image, {0, rows_in_64ths}), warp).at(5, 10);
   };
   EXPECT_EQ(middle(3 * 64), 200);
   EXPECT_EQ(middle(3 * 64 + 32), 100);
   EXPECT_EQ(middle(4 * 64), 0);
   EXPECT_EQ(middle(-2 * 64), 200);
   EXPECT_EQ(middle(-2 * 64 - 32), 100);
   EXPECT_EQ(middle(-3 * 64), 0);
}

TEST(Rectification, RowsNeededAreEnoughAndNoneIsTooMuch) {
   Random random(test_seed());
   constexpr int kWidth = 40, kHeight = 30;
   int smaller = 0;
   for (int round = 0; round < 40; ++round) {
      Warp warp{.grid_px = 8, .rows_above = 255, .rows_below = 255};
      GrayImage image = random_image(kWidth, kHeight, random);
      for (uint8_t& pixel : image.pixels) pixel |= 128;  // what is left out shows
      Table table(warp, kWidth, kHeight);
      for (Offset& node : table.nodes) node = {random.below(1024) - 512, random.below(1024) - 512};
      const RowsNeeded needed = rows_needed(table, warp, kWidth, kHeight);
      const GrayImage whole = rectified(image, table, warp);
      warp.rows_above = needed.above;
      warp.rows_below = needed.below;
      ASSERT_EQ(rectified(image, table, warp), whole);
      for (int Warp::*rows : {&Warp::rows_above, &Warp::rows_below}) {
         Warp fewer = warp;
         if (--(fewer.*rows) < 0) continue;
         // A tap of weight 0 changes nothing, but it counts as one that is needed.
         smaller += rectified(image, table, fewer) == whole ? 0 : 1;
      }
   }
   EXPECT_GE(smaller, 60) << "of 80";
}

TEST(Rectification, RefusesWhatDoesNotFit) {
   const GrayImage image(40, 30);
   const Warp warp;
   EXPECT_THROW(rectified(image, Table(warp, 56, 30), warp), std::invalid_argument);
   EXPECT_THROW(rectified(image, Table(warp, 40, 30), Warp{.grid_px = 12}), std::invalid_argument);
   EXPECT_NO_THROW(rectified(image, Table(warp, 40, 30), warp));
   DeepImage deep(40, 30, 1023);
   EXPECT_NO_THROW(rectified(deep, Table(warp, 40, 30), Warp{.pixel_bits = 10}));
   deep.at(7, 5) = 1024;
   EXPECT_THROW(rectified(deep, Table(warp, 40, 30), Warp{.pixel_bits = 10}), std::invalid_argument);
}

}  // namespace
}  // namespace stereo::rectification
