// SPDX-License-Identifier: Apache-2.0
#include "program/video/frame_names.hpp"

#include <gtest/gtest.h>

namespace stereo::app {
namespace {

using Names = std::vector<std::string>;
using Pairs = std::vector<std::pair<std::string, std::string>>;

TEST(FrameNames, NumbersCountAsNumbers) {
   Names names{"10.png", "1.png", "11.png", "2.png", "b.png", "003.png", "a2_10.png", "a2_9.png", "a10_1.png"};
   sort_by_number(names);
   EXPECT_EQ(names,
             (Names{"1.png", "2.png", "003.png", "10.png", "11.png", "a2_9.png", "a2_10.png", "a10_1.png", "b.png"}));
}

void expect_pairs(const Names& left, const Names& right, const Pairs& pairs, const Names& left_alone = {},
                  const Names& right_alone = {}) {
   const PairedNames found = pair_names(left, right);
   EXPECT_EQ(found.pairs, pairs);
   EXPECT_EQ(found.left_alone, left_alone);
   EXPECT_EQ(found.right_alone, right_alone);
   const PairedNames exchanged = pair_names(right, left);
   ASSERT_EQ(exchanged.pairs.size(), pairs.size());
   for (std::size_t i = 0; i < pairs.size(); ++i)
      EXPECT_EQ(exchanged.pairs[i], std::pair(pairs[i].second, pairs[i].first));
}

TEST(FrameNames, MissingFramesMoveNone) {
   expect_pairs({"0.png", "1.png", "3.png", "4.png"}, {"0.png", "2.png", "3.png", "4.png"},
                {{"0.png", "0.png"}, {"3.png", "3.png"}, {"4.png", "4.png"}}, {"1.png"}, {"2.png"});
}

TEST(FrameNames, LeadingZerosAndEndingsDoNotCount) {
   expect_pairs({"1.png", "2.png", "10.png", "12.png"}, {"001.jpg", "002.jpg", "010.jpg", "011.jpg"},
                {{"1.png", "001.jpg"}, {"2.png", "002.jpg"}, {"10.png", "010.jpg"}}, {"12.png"}, {"011.jpg"});
}

TEST(FrameNames, NamesOfCamerasDoNotCount) {
   expect_pairs({"left_9.png", "left_10.png"}, {"right_9.png", "right_10.png"},
                {{"left_9.png", "right_9.png"}, {"left_10.png", "right_10.png"}});
   expect_pairs({"cam0_001.png", "cam0_002.png"}, {"cam1_001.png", "cam1_002.png"},
                {{"cam0_001.png", "cam1_001.png"}, {"cam0_002.png", "cam1_002.png"}});
   expect_pairs({"001_L0.png", "002_L0.png"}, {"001_R1.png", "002_R1.png"},
                {{"001_L0.png", "001_R1.png"}, {"002_L0.png", "002_R1.png"}});
   expect_pairs({"left.png"}, {"right.png"}, {{"left.png", "right.png"}});
}

TEST(FrameNames, TwoNumbersAreOnePlace) {
   expect_pairs(
       {"000000_10.png", "000000_11.png", "000001_10.png"}, {"000000_10.png", "000001_10.png", "000001_11.png"},
       {{"000000_10.png", "000000_10.png"}, {"000001_10.png", "000001_10.png"}}, {"000000_11.png"}, {"000001_11.png"});
}

TEST(FrameNames, NumbersMayBeLong) {
   expect_pairs({"1403636579763555584.png", "999999999999999999.png"}, {"1403636579763555584.png"},
                {{"1403636579763555584.png", "1403636579763555584.png"}}, {"999999999999999999.png"});
   expect_pairs({"99999999999999999999.png", "100000000000000000000.png"},
                {"99999999999999999999.png", "100000000000000000000.png"},
                {{"99999999999999999999.png", "99999999999999999999.png"},
                 {"100000000000000000000.png", "100000000000000000000.png"}});
}

TEST(FrameNames, NothingInCommonPairsNothing) {
   expect_pairs({"1.png", "2.png"}, {"3.png", "4.png"}, {}, {"1.png", "2.png"}, {"3.png", "4.png"});
   expect_pairs({"a.png", "b.png"}, {"c.png", "d.png"}, {}, {"a.png", "b.png"}, {"c.png", "d.png"});
   expect_pairs({"1.png", "01.png"}, {"1.jpg", "01.jpg"}, {}, {"1.png", "01.png"}, {"1.jpg", "01.jpg"});
}

}  // namespace
}  // namespace stereo::app
