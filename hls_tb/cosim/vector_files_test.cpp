// SPDX-License-Identifier: Apache-2.0
#include "cosim/vector_files.hpp"

#include <gtest/gtest.h>

#include <sstream>

namespace stereo::test {
namespace {

std::string text_of(const Stimulus& stimulus) {
   std::ostringstream out;
   write_stimulus(out, stimulus);
   return out.str();
}

std::string text_of(const Expected& expected) {
   std::ostringstream out;
   write_expected(out, expected);
   return out.str();
}

TEST(VectorFiles, Stimulus) {
   EXPECT_EQ(text_of(Stimulus{"tiny",
                              1,
                              {{.left = {0x0a}, .right = {0xff}, .start_of_frame = true, .valid = true},
                               {.left = {0x00}, .right = {0x10}},
                               {.left = {0x7f}, .right = {0x80}, .valid = true}}}),
             "stereo-hls stimulus 2 config=tiny pixels=1 clocks=3\n3 0a ff\n0 00 10\n1 7f 80\n");
}

TEST(VectorFiles, AStartOfFrameMayStandInABubble) {
   EXPECT_EQ(text_of(Stimulus{"tiny", 1, {{.left = {1}, .right = {2}, .start_of_frame = true}}}),
             "stereo-hls stimulus 2 config=tiny pixels=1 clocks=1\n2 01 02\n");
}

TEST(VectorFiles, AResetIsAFlag) {
   EXPECT_EQ(text_of(Stimulus{"tiny", 1, {{.valid = true}, {.start_of_frame = true, .valid = true}, {}}, {1, 2}}),
             "stereo-hls stimulus 2 config=tiny pixels=1 clocks=3\n1 00 00\n7 00 00\n4 00 00\n");
}

TEST(VectorFiles, TheLastLaneComesFirstInTheText) {
   EXPECT_EQ(text_of(Stimulus{"tiny_p4",
                              4,
                              {{.left = {0x0a, 0x0b, 0x0c, 0x0d},
                                .right = {0x80, 0x01, 0x00, 0xff},
                                .start_of_frame = true,
                                .valid = true},
                               {.left = {}, .right = {0x78, 0x56, 0x34, 0x12}}}}),
             "stereo-hls stimulus 2 config=tiny_p4 pixels=4 clocks=2\n3 0d0c0b0a ff000180\n0 00000000 12345678\n");
}

TEST(VectorFiles, LanesThatAreNotInUseAreNotWritten) {
   EXPECT_EQ(text_of(Stimulus{"tiny_p2", 2, {{.left = {1, 2, 3, 4}, .right = {5, 6, 7, 8}, .valid = true}}}),
             "stereo-hls stimulus 2 config=tiny_p2 pixels=2 clocks=1\n1 0201 0605\n");
}

TEST(VectorFiles, PixelsOfMoreBitsHaveNarrowLanes) {
   Stimulus one{"tiny_10bit", 1, {{.left = {0x3ff}, .right = {0x012}, .valid = true}}};
   one.pixel_bits = 10;
   EXPECT_EQ(text_of(one), "stereo-hls stimulus 2 config=tiny_10bit pixels=1 clocks=1 pixel_bits=10\n1 3ff 012\n");
   Stimulus two{"two", 2, {{.left = {0x3ff, 0x001}, .right = {0x000, 0x3ff}, .valid = true}}};
   two.pixel_bits = 10;
   EXPECT_EQ(text_of(two), "stereo-hls stimulus 2 config=two pixels=2 clocks=1 pixel_bits=10\n1 007ff ffc00\n");
}

TEST(VectorFiles, ExpectedOutputs) {
   const CoreOutput first{.clock = 50, .x = 0, .y = 0, .frame = 0, .disparity = {255}, .start_of_frame = true};
   const CoreOutput second{
       .clock = 51, .x = 1, .y = 0, .frame = 0, .disparity = {7}, .pixel_valid = {true}, .end_of_line = true};
   EXPECT_EQ(text_of(Expected{"tiny", 1, 8, 10, {first, second}}),
             "stereo-hls expected 2 config=tiny pixels=1 disparity_bits=8 outputs=2 latency=10\n50 0 0 0 ff 1\n"
             "51 1 0 0 07 6\n");
}

TEST(VectorFiles, ExpectedOutputsOfSeveralRowsInSixteenths) {
   const CoreOutput first{
       .clock = 50, .x = 0, .y = 2, .frame = 0, .disparity = {0x0001, 0x0fff}, .start_of_frame = true};
   const CoreOutput second{.clock = 51,
                           .x = 1,
                           .y = 2,
                           .frame = 0,
                           .disparity = {0, 0x0700},
                           .pixel_valid = {false, true},
                           .end_of_line = true};
   EXPECT_EQ(text_of(Expected{"tiny_p2", 2, 16, 10, {first, second}}),
             "stereo-hls expected 2 config=tiny_p2 pixels=2 disparity_bits=16 outputs=2 latency=10\n"
             "50 0 2 0 0fff0001 1\n51 1 2 0 07000000 10\n");
}

/// Above the disparity: filled in bit 15, the confidence in the 8 bits above.
TEST(VectorFiles, ExpectedOutputsWithWhatPostProcessingGives) {
   const CoreOutput measured{.clock = 50,
                             .x = 0,
                             .y = 0,
                             .frame = 0,
                             .disparity = {0x0123},
                             .pixel_valid = {true},
                             .confidence = {0xfe},
                             .start_of_frame = true};
   const CoreOutput filled{
       .clock = 51, .x = 1, .y = 0, .frame = 0, .disparity = {0x0123}, .filled = {true}, .end_of_line = true};
   EXPECT_EQ(text_of(Expected{"tiny_dense", 1, 24, 10, {measured, filled}, true, true}),
             "stereo-hls expected 2 config=tiny_dense pixels=1 disparity_bits=24 outputs=2 latency=10\n"
             "50 0 0 0 fe0123 5\n51 1 0 0 008123 2\n");
   EXPECT_EQ(text_of(Expected{"tiny_fill", 1, 16, 10, {filled}, false, true}),
             "stereo-hls expected 2 config=tiny_fill pixels=1 disparity_bits=16 outputs=1 latency=10\n"
             "51 1 0 0 8123 2\n");
   const CoreOutput whole{
       .clock = 50, .x = 0, .y = 0, .frame = 0, .disparity = {0x23}, .pixel_valid = {true}, .confidence = {0xfe}};
   EXPECT_EQ(text_of(Expected{"sure", 1, 16, 10, {whole}, true, false}),
             "stereo-hls expected 2 config=sure pixels=1 disparity_bits=16 outputs=1 latency=10\n50 0 0 0 fe23 4\n");
}

TEST(VectorFiles, NothingIsAFirstLine) {
   EXPECT_EQ(text_of(Stimulus{"tiny", 1, {}}), "stereo-hls stimulus 2 config=tiny pixels=1 clocks=0\n");
   EXPECT_EQ(text_of(Expected{"tiny", 1, 8, 10, {}}),
             "stereo-hls expected 2 config=tiny pixels=1 disparity_bits=8 outputs=0 latency=10\n");
}

}  // namespace
}  // namespace stereo::test
