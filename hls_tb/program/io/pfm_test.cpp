// SPDX-License-Identifier: Apache-2.0
#include "program/io/pfm.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <stdexcept>
#include <string>

#include "scene/random.hpp"
#include "testing/seed.hpp"

namespace stereo::app {
namespace {

using namespace std::string_literals;

/// Four bytes of a float.
std::string bytes_of(float value, bool little_endian) {
   const auto word = std::bit_cast<uint32_t>(value);
   std::string bytes;
   for (int i = 0; i < 4; ++i) bytes += char(word >> (8 * (little_endian ? i : 3 - i)) & 0xff);
   return bytes;
}

std::string pixels(const std::vector<float>& values, bool little_endian) {
   std::string bytes;
   for (const float value : values) bytes += bytes_of(value, little_endian);
   return bytes;
}

std::string sentence(const std::string& bytes) {
   try {
      parse_pfm(bytes);
   } catch (const std::invalid_argument& problem) {
      return problem.what();
   }
   return "";
}

const std::vector<float> kSix{1, 2.25F, 3, -4, 5.5F, 60000};

TEST(Pfm, BothByteOrdersFromTheBottomRowUp) {
   for (const bool little_endian : {true, false}) {
      const std::string header = little_endian ? "Pf\n3 2\n-1.0\n" : "Pf 3\t2\r\n 0.5\n";
      const DisparityImage image = parse_pfm(header + pixels(kSix, little_endian));
      ASSERT_EQ(image.width, 3);
      ASSERT_EQ(image.height, 2);
      EXPECT_EQ(image.px, (std::vector<float>{-4, 5.5F, 60000, 1, 2.25F, 3})) << little_endian;
   }
}

TEST(Pfm, ValuesAreThoseOfTheFile) {
   constexpr float kInfinity = std::numeric_limits<float>::infinity(), kNan = std::numeric_limits<float>::quiet_NaN();
   const DisparityImage image = parse_pfm("Pf\n5 1\n-1\n" + pixels({kInfinity, 7, -kInfinity, kNan, 1e30F}, true));
   EXPECT_EQ(image.at(0, 0), kInfinity);
   EXPECT_EQ(image.at(1, 0), 7);
   EXPECT_EQ(image.at(2, 0), -kInfinity);
   EXPECT_TRUE(std::isnan(image.at(3, 0)));
   EXPECT_EQ(image.at(4, 0), 1e30F);
}

TEST(Pfm, RefusesWhatIsNoDisparityMap) {
   const std::string four = pixels({1}, true);
   const std::pair<std::string, std::string> cases[] = {
       {"", "truncated"},
       {"Pf", "truncated"},
       {"Pf\n", "truncated"},
       {"Pf\n3 2\n-1.0", "truncated"},
       {std::string(100, 'P'), "truncated"},
       {"PF\n1 1\n-1\n" + four + four + four, "colour"},
       {"P5\n1 1\n255\n" + four, "does not begin with Pf"},
       {"Pf\n0 1\n-1\n", "a width of 0"},
       {"Pf\n1 0\n-1\n", "a height of 0"},
       {"Pf\n-1 1\n-1\n" + four, "a width of -1"},
       {"Pf\n65537 1\n-1\n", "a width of 65537"},
       {"Pf\n99999999999999999999 1\n-1\n", "no number as the width"},
       {"Pf\n1x 1\n-1\n" + four, "no number as the width"},
       {"Pf\n1 one\n-1\n" + four, "no number as the height"},
       {"Pf\n1 1\n0\n" + four, "a scale that gives no byte order"},
       {"Pf\n1 1\nnan\n" + four, "a scale that gives no byte order"},
       {"Pf\n1 1\n-inf\n" + four, "a scale that gives no byte order"},
       {"Pf\n1 1\nbig\n" + four, "no number as the scale"},
       {"Pf\n65536 65536\n-1\n" + four, "4 bytes of pixels but its PFM header says 17179869184"},
       {"Pf\n1 1\n-1\n" + four.substr(1), "3 bytes of pixels but its PFM header says 4"},
       {"Pf\n1 1\n-1\n" + four + "x", "5 bytes of pixels but its PFM header says 4"}};
   for (const auto& [bytes, words] : cases)
      EXPECT_NE(sentence(bytes).find(words), std::string::npos) << words << ": " << sentence(bytes);
}

// Every prefix and random damage: a map of the right size or one sentence, never anything else.
TEST(Pfm, SurvivesDamage) {
   const std::string whole = "Pf\n3 2\n-1.0\n" + pixels(kSix, true);
   for (std::size_t length = 0; length < whole.size(); ++length) EXPECT_NE(sentence(whole.substr(0, length)), "");
   Random random(test::test_seed());
   int taken = 0;
   for (int round = 0; round < 20000; ++round) {
      std::string damaged = whole;
      for (int i = random.below(3); i >= 0; --i)
         damaged[std::size_t(random.below(int(damaged.size())))] = char(random.below(256));
      try {
         const DisparityImage image = parse_pfm(damaged);
         ASSERT_EQ(image.px.size(), std::size_t(image.width) * std::size_t(image.height));
         ++taken;
      } catch (const std::invalid_argument& problem) {
         ASSERT_NE(problem.what(), ""s);
      }
   }
   EXPECT_GT(taken, 0);
}

}  // namespace
}  // namespace stereo::app
