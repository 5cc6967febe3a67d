// SPDX-License-Identifier: Apache-2.0
// The steps of the definition on cases small enough to work out by hand.
#include "definition/phase_correlation/reference_model.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <type_traits>

#include "scene/random.hpp"
#include "testing/seed.hpp"
#include "testing/test_pairs.hpp"

namespace stereo::test {
namespace {

using phase_correlation::responses;

/// value(x, y), for every pixel.
template <class Value>
GrayImage image_of(int width, int height, const Value& value) {
   GrayImage image(width, height);
   for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) image.at(x, y) = uint8_t(value(x, y));
   return image;
}

TEST(PhaseCorrelation, ResponsesByHand) {
   // A slope along x: the even filters see nothing. O = 2 + 2 * 1 - 2 * (-1) - (-2) = 8 for each grey value a column,
   // times the sum of the taps of L, 4.
   const GrayImage slope = image_of(9, 9, [](int x, int) { return 10 * x; });
   EXPECT_EQ(responses(slope, 4, 4, 0), (std::array<int, 6>{0, 8 * 10 * 4, 0, 0, 0, 0}));
   // A single pixel at (x,y) and at (x+1,y+2).
   const GrayImage centre = image_of(9, 9, [](int x, int y) { return x == 4 && y == 4 ? 100 : 0; });
   EXPECT_EQ(responses(centre, 4, 4, 0), (std::array<int, 6>{2 * 2 * 100, 0, 4 * 100, 0, 4 * 100, 0}));
   const GrayImage aside = image_of(9, 9, [](int x, int y) { return x == 5 && y == 6 ? 100 : 0; });
   // Along x: e = 0, o = 2; along y: L = 0, E = -1, O = 1. ee = 0, oe = -2, eo = 0, oo = 2.
   EXPECT_EQ(responses(aside, 4, 4, 0), (std::array<int, 6>{0, 0, -200, -200, 200, -200}));
   // With a step of 2, pixel (x-1,y-1) is one of the four of the box in the centre.
   const GrayImage beside = image_of(11, 11, [](int x, int y) { return x == 5 && y == 5 ? 100 : 0; });
   EXPECT_EQ(responses(beside, 6, 6, 1), (std::array<int, 6>{400, 0, 400, 0, 400, 0}));
}

/// Of images of black and white.
template <class Image>
void expect_ranges(int white) {
   for (int scale = 0; scale < 3; ++scale) {
      const int before = phase_correlation::reach_before(scale),
                side = before + phase_correlation::reach_after(scale) + 1;
      const int pixels = 1 << 2 * scale;
      Random random(test_seed());
      for (int i = 0; i < 200; ++i) {
         Image image(side, side);
         for (auto& pixel : image.pixels)
            pixel = std::remove_reference_t<decltype(pixel)>(random.percent(50) ? white : 0);
         const std::array<int, 6> parts = responses(image, before, before, scale);
         for (std::size_t bit = 0; bit < parts.size(); ++bit)
            ASSERT_LE(std::abs(parts[bit]), (bit == 0 ? 8 : bit == 1 ? 12 : 26) * white * pixels);
      }
   }
}

TEST(PhaseCorrelation, ResponsesStayWithinTheirRanges) {
   expect_ranges<GrayImage>(255);
   expect_ranges<DeepImage>(1023);
   expect_ranges<DeepImage>(4095);
}

TEST(PhaseCorrelation, CodesSeeTheLowestBitsOfDeepImages) {
   // 4095 and 4094 are one white for 8 bits.
   const GrayImage low = random_pair(30, 26, test_seed(), 2).left;
   DeepImage bright(low.width, low.height);
   for (std::size_t i = 0; i < low.pixels.size(); ++i) bright.pixels[i] = low.pixels[i] != 0 ? 4095 : 4094;
   EXPECT_EQ(phase_correlation::phase_codes(bright, 3).bits, phase_correlation::phase_codes(low, 3).bits);
   EXPECT_EQ(phase_correlation::phase_codes(widened(low), 3).bits, phase_correlation::phase_codes(low, 3).bits);
}

TEST(PhaseCorrelation, CodesAre0WhereTheFiltersReachOutside) {
   const GrayImage image = random_pair(30, 26, test_seed()).left;
   const CensusImage codes = phase_correlation::phase_codes(image, 3);
   for (int y = 0; y < image.height; ++y)
      for (int x = 0; x < image.width; ++x)
         for (int scale = 0; scale < 3; ++scale) {
            const int step = 1 << scale;
            const bool inside = x >= 3 * step - 1 && x <= image.width - 1 - 2 * step && y >= 3 * step - 1 &&
                                y <= image.height - 1 - 2 * step;
            const uint64_t bits = codes.at(x, y) >> 6 * scale & 63;
            uint64_t wanted = 0;
            if (inside) {
               const std::array<int, 6> parts = responses(image, x, y, scale);
               for (std::size_t bit = 0; bit < 6; ++bit) wanted |= uint64_t(parts[bit] > 0) << bit;
            }
            ASSERT_EQ(bits, wanted) << x << ' ' << y << ' ' << scale;
         }
}

TEST(PhaseCorrelation, GainAndOffsetOfACameraChangeNoCode) {
   // Without rounding and clamping: the responses are linear, and none sees a constant.
   const GrayImage dark = image_of(24, 20, [](int x, int y) { return (x * 37 + y * y * 11 + x * y * 5) % 100; });
   GrayImage bright = dark;
   for (uint8_t& pixel : bright.pixels) pixel = uint8_t(2 * pixel + 50);
   EXPECT_EQ(phase_correlation::phase_codes(dark, 3).bits, phase_correlation::phase_codes(bright, 3).bits);
}

TEST(PhaseCorrelation, TheFinestScaleCountsTwice) {
   EXPECT_EQ(phase_correlation::code_cost(0b101101, 0, 1), 4);
   EXPECT_EQ(phase_correlation::code_cost(0b111111'000111, 0b000001'000000, 2), 2 * 3 + 5);
   EXPECT_EQ(phase_correlation::code_cost((uint64_t(1) << 18) - 1, 0, 3), 24);
}

TEST(PhaseCorrelation, FindsAShift) {
   phase_correlation::Matching matching{DisparityCount{12}, MatchingWindow{5}};
   for (const Reference reference : {Reference::right, Reference::left}) {
      matching.reference = reference;
      const ImagePair pair = shifted_pair(60, 30, 7, test_seed());
      const DisparityMap map = match_reference(pair.left, pair.right, matching);
      for (int y = 8; y < 22; ++y)
         for (int x = 16; x < 32; ++x) ASSERT_EQ(map.at(x, y), 7) << x << ' ' << y;
   }
}

}  // namespace
}  // namespace stereo::test
