// SPDX-License-Identifier: Apache-2.0
#include "program/io/npy.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <stdexcept>
#include <string>

#include "scene/random.hpp"
#include "testing/seed.hpp"

namespace stereo::app {
namespace {

using namespace std::string_literals;

/// As numpy.save writes it: magic, version, length, header, values.
std::string npy(const std::string& type, const std::string& order, const std::string& shape, const std::string& values,
                char version = 1) {
   const std::string header =
       "{'descr': '" + type + "', 'fortran_order': " + order + ", 'shape': (" + shape + "), }          \n";
   std::string bytes = "\x93NUMPY"s + version + '\0' + char(header.size()) + '\0';
   if (version > 1) bytes += "\0\0"s;
   return bytes + header + values;
}

template <class Word>
std::string word(Word value, bool little_endian) {
   std::string bytes;
   for (std::size_t i = 0; i < sizeof(Word); ++i)
      bytes += char(value >> (8 * (little_endian ? i : sizeof(Word) - 1 - i)) & 0xff);
   return bytes;
}

std::string floats(const std::vector<float>& values, bool little_endian = true) {
   std::string bytes;
   for (const float value : values) bytes += word(std::bit_cast<uint32_t>(value), little_endian);
   return bytes;
}

std::string sentence(const std::string& bytes) {
   try {
      parse_npy(bytes);
   } catch (const std::invalid_argument& problem) {
      return problem.what();
   }
   return "";
}

TEST(Npy, EveryOrderOfBytesAndAxes) {
   const std::vector<float> rows{1, 2.25F, 3, -4, 5.5F, 60000}, columns{1, -4, 2.25F, 5.5F, 3, 60000};
   for (const char version : {1, 2, 3})
      for (const std::string& bytes : {npy("<f4", "False", "2, 3", floats(rows), version),
                                       npy(">f4", "False", "2, 3", floats(rows, false), version),
                                       npy("<f4", "True", "2, 3", floats(columns), version),
                                       npy("<f4", "False", "2, 3, 1", floats(rows), version)}) {
         const DisparityImage image = parse_npy(bytes);
         ASSERT_EQ(image.width, 3);
         ASSERT_EQ(image.height, 2);
         EXPECT_EQ(image.px, rows);
      }
}

TEST(Npy, DoubleAndHalfPrecision) {
   const std::string doubles = word(std::bit_cast<uint64_t>(7.0625), true) + word(std::bit_cast<uint64_t>(-1.0), true);
   EXPECT_EQ(parse_npy(npy("<f8", "False", "1, 2", doubles)).px, (std::vector<float>{7.0625F, -1}));
   // 1, -2, 65504, the smallest above 0, infinity, none.
   const std::string halves = "\x00\x3c\x00\xc0\xff\x7b\x01\x00\x00\x7c\x00\x7e"s;
   const DisparityImage image = parse_npy(npy("<f2", "False", "1, 6", halves));
   EXPECT_EQ(std::vector<float>(image.px.begin(), image.px.begin() + 4),
             (std::vector<float>{1, -2, 65504, std::ldexp(1.0F, -24)}));
   EXPECT_TRUE(std::isinf(image.px[4]));
   EXPECT_TRUE(std::isnan(image.px[5]));
}

TEST(Npy, RefusesWhatIsNoMap) {
   const std::string four = floats({1});
   const std::pair<std::string, std::string> cases[] = {
       {"", "does not begin"},
       {"\x93NUMPX", "does not begin"},
       {"\x93NUMPY\1", "truncated"},
       {"\x93NUMPY\1\0\xff\0{"s, "truncated"},
       {"\x93NUMPY\4\0\1\0{"s, "another version"},
       {"\x93NUMPY\2\0\xff\xff\xff\xff{"s, "truncated"},
       {"\x93NUMPY\1\0\3\0{}\n"s, "names no array"},
       {npy("<u2", "False", "1, 1", "xx"), "an array of <u2"},
       {npy("|O", "False", "1, 1", four), "an array of |O"},
       {npy("a\n\xff", "False", "1, 1", four), "an array of a??;"},
       {npy("<f9", "False", "1, 1", four), "an array of <f9"},
       {npy("<f4", "False", "1,", four), "shape (1,)"},
       {npy("<f4", "False", "1, 1, 2", four + four), "two axes"},
       {npy("<f4", "False", "0, 1", ""), "an axis of 0"},
       {npy("<f4", "False", "1, 99999999999999999999", four), "an axis of 99999999999999999999"},
       {npy("<f4", "False", "65536, 65536", four), "4 bytes of values"},
       {npy("<f4", "False", "1, 1", four + "x"), "5 bytes of values"},
       {npy("<f4", "maybe", "1, 1", four), "names no array"}};
   for (const auto& [bytes, words] : cases)
      EXPECT_NE(sentence(bytes).find(words), std::string::npos) << words << ": " << sentence(bytes);
}

TEST(Npy, SurvivesDamage) {
   const std::string whole = npy("<f4", "False", "2, 3", floats({1, 2, 3, 4, 5, 6}));
   for (std::size_t length = 0; length < whole.size(); ++length) EXPECT_NE(sentence(whole.substr(0, length)), "");
   Random random(test::test_seed());
   int taken = 0;
   for (int round = 0; round < 3000; ++round) {
      std::string damaged = whole;
      for (int i = random.below(3); i >= 0; --i)
         damaged[std::size_t(random.below(int(damaged.size())))] = char(random.below(256));
      try {
         const DisparityImage image = parse_npy(damaged);
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
