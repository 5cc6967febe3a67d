// SPDX-License-Identifier: Apache-2.0
#include "vectors/vector_files.hpp"

#include <gtest/gtest.h>

#include <array>
#include <sstream>
#include <stdexcept>

#include "support/seed.hpp"

namespace stereo::test {
namespace {

const std::string kStimulus = "stereo-hls stimulus 1 config=tiny pixels=1 clocks=3\n3 0a ff\n0 00 10\n1 7f 80\n";
const std::string kExpected =
    "stereo-hls expected 2 config=tiny pixels=1 disparity_bits=8 outputs=2 latency=10\n50 0 0 0 ff 1\n51 1 0 0 07 6\n";
const std::string kStimulusOfFour =
    "stereo-hls stimulus 1 config=tiny_p4 pixels=4 clocks=2\n3 0d0c0b0a ff000180\n0 00000000 12345678\n";
const std::string kExpectedOfTwo =
    "stereo-hls expected 2 config=tiny_p2 pixels=2 disparity_bits=16 outputs=2 latency=10\n50 0 2 0 0fff0001 1\n51 1 2 0 07000000 10\n";

Stimulus stimulus_of(const std::string& text) {
   std::istringstream in(text);
   return read_stimulus(in, "stimulus.txt");
}

Expected expected_of(const std::string& text) {
   std::istringstream in(text);
   return read_expected(in, "expected.txt");
}

TEST(VectorFiles, ReadsAStimulus) {
   const Stimulus stimulus = stimulus_of(kStimulus);
   EXPECT_EQ(stimulus.config, "tiny");
   EXPECT_EQ(stimulus.pixels_per_clock, 1);
   ASSERT_EQ(stimulus.clocks.size(), 3u);
   EXPECT_EQ(stimulus.clocks[0].left[0], 0x0a);
   EXPECT_EQ(stimulus.clocks[0].right[0], 0xff);
   EXPECT_TRUE(stimulus.clocks[0].valid && stimulus.clocks[0].start_of_frame);
   EXPECT_FALSE(stimulus.clocks[1].valid || stimulus.clocks[1].start_of_frame);
   EXPECT_TRUE(stimulus.clocks[2].valid && !stimulus.clocks[2].start_of_frame);
}

TEST(VectorFiles, TheLastLaneComesFirstInTheText) {
   const Stimulus stimulus = stimulus_of(kStimulusOfFour);
   EXPECT_EQ(stimulus.pixels_per_clock, 4);
   ASSERT_EQ(stimulus.clocks.size(), 2u);
   EXPECT_EQ(std::to_array(stimulus.clocks[0].left), (std::array<uint8_t, 4>{0x0a, 0x0b, 0x0c, 0x0d}));
   EXPECT_EQ(std::to_array(stimulus.clocks[0].right), (std::array<uint8_t, 4>{0x80, 0x01, 0x00, 0xff}));
   const Expected expected = expected_of(kExpectedOfTwo);
   EXPECT_EQ(expected.pixels_per_clock, 2);
   ASSERT_EQ(expected.outputs.size(), 2u);
   EXPECT_EQ(expected.outputs[0].y, 2);
   EXPECT_EQ(expected.outputs[0].disparity, (std::array<uint16_t, 4>{0x001, 0xfff, 0, 0}));
   EXPECT_EQ(expected.outputs[1].pixel_valid, (std::array<bool, 4>{false, true, false, false}));
}

TEST(VectorFiles, ReadsExpectedOutputs) {
   const Expected expected = expected_of(kExpected);
   EXPECT_EQ(expected.config, "tiny");
   EXPECT_EQ(expected.pixels_per_clock, 1);
   EXPECT_EQ(expected.latency_clocks, 10);
   ASSERT_EQ(expected.outputs.size(), 2u);
   const CoreOutput first{.clock = 50, .x = 0, .y = 0, .frame = 0, .disparity = {255}, .start_of_frame = true};
   EXPECT_EQ(expected.outputs[0], first);
   const CoreOutput second{.clock = 51, .x = 1, .y = 0, .frame = 0, .disparity = {7}, .pixel_valid = {true}, .end_of_line = true};
   EXPECT_EQ(expected.outputs[1], second);
}

TEST(VectorFiles, WritesWhatItReads) {
   for (const std::string& text : {kStimulus, kStimulusOfFour}) {
      std::ostringstream out;
      write_stimulus(out, stimulus_of(text));
      EXPECT_EQ(out.str(), text);
   }
   for (const std::string& text : {kExpected, kExpectedOfTwo}) {
      std::ostringstream out;
      write_expected(out, expected_of(text));
      EXPECT_EQ(out.str(), text);
   }
}

TEST(VectorFiles, RoundTripOfRandomClocks) {
   for (const int pixels : {1, 2, 4}) {
      StimulusWriter writer(pixels, 50, test_seed());
      writer.random_records(1000);
      std::ostringstream first, second;
      write_stimulus(first, {"name", pixels, writer.clocks});
      const Stimulus read = stimulus_of(first.str());
      write_stimulus(second, read);
      EXPECT_EQ(first.str(), second.str());
      ASSERT_EQ(read.clocks.size(), writer.clocks.size());
      for (std::size_t i = 0; i < read.clocks.size(); ++i) {
         ASSERT_EQ(std::to_array(read.clocks[i].left), std::to_array(writer.clocks[i].left)) << "clock " << i;
         ASSERT_EQ(std::to_array(read.clocks[i].right), std::to_array(writer.clocks[i].right)) << "clock " << i;
      }
   }
}

struct Damage {
   std::string name, text, complaint;
};

std::string replaced(std::string text, const std::string& from, const std::string& to) {
   return text.replace(text.find(from), from.size(), to);
}

template <class Read>
void expect_refused(const std::vector<Damage>& damages, Read read) {
   for (const Damage& damage : damages) try {
         read(damage.text);
         ADD_FAILURE() << "accepted: " << damage.name;
      } catch (const std::runtime_error& error) {
         EXPECT_EQ(std::string(error.what()).find(damage.complaint), 0u) << damage.name << ": " << error.what();
      }
}

TEST(VectorFiles, RefusesDamagedStimuli) {
   expect_refused(
       {{"empty", "", "stimulus.txt:1: the file ends"},
        {"other format", kExpected, "stimulus.txt:1: the first line must begin with"},
        {"other version", replaced(kStimulus, "1 config", "2 config"), "stimulus.txt:1: the first line must"},
        {"no count", replaced(kStimulus, " clocks=3", ""), "stimulus.txt:1: "},
        {"count is no number", replaced(kStimulus, "=3", "=3x"), "stimulus.txt:1: \"3x\" is not a number"},
        {"more in the first line", replaced(kStimulus, "=3", "=3 a=b"), "stimulus.txt:1: the first line goes on"},
        {"count too large", replaced(kStimulus, "=3", "=4"), "stimulus.txt:5: the file ends where clock 3 of 4"},
        {"count too small", replaced(kStimulus, "=3", "=2"), "stimulus.txt:4: more lines"},
        {"no pixels", replaced(kStimulus, " pixels=1", ""), "stimulus.txt:1: "},
        {"three pixels", replaced(kStimulus, "pixels=1", "pixels=3"), "stimulus.txt:1: pixels=3 but 1, 2 or 4"},
        {"more pixels than digits", replaced(kStimulus, "pixels=1", "pixels=2"),
         "stimulus.txt:2: \"3 0a ff\" is not of"},
        {"more digits than pixels", replaced(kStimulusOfFour, "pixels=4", "pixels=2"),
         "stimulus.txt:2: \"3 0d0c0b0a ff000180\" is not of the form \"F LLLL RRRR\""},
        {"a digit less", replaced(kStimulusOfFour, "12345678", "1234567"), "stimulus.txt:3: "},
        {"digits of left in right", replaced(kStimulusOfFour, "0d0c0b0a ff", "0d0c0b0aff "), "stimulus.txt:2: "},
        {"truncated line", kStimulus.substr(0, kStimulus.size() - 2), "stimulus.txt:4: \"1 7f 8\" is not of"},
        {"bad digit", replaced(kStimulus, "ff", "fg"), "stimulus.txt:2: "},
        {"upper-case digit", replaced(kStimulus, "ff", "FF"), "stimulus.txt:2: "},
        {"flags beyond 3", replaced(kStimulus, "\n0 00", "\n4 00"), "stimulus.txt:3: "},
        {"no blank", replaced(kStimulus, "0 00 10", "0x00x10"), "stimulus.txt:3: "},
        {"empty line", replaced(kStimulus, "0 00 10", ""), "stimulus.txt:3: "}},
       stimulus_of);
}

TEST(VectorFiles, RefusesDamagedExpectedOutputs) {
   expect_refused(
       {{"empty", "", "expected.txt:1: the file ends"},
        {"other format", kStimulus, "expected.txt:1: the first line must begin with"},
        {"no latency", replaced(kExpected, " latency=10", ""), "expected.txt:1: "},
        {"count too large", replaced(kExpected, "outputs=2", "outputs=3"), "expected.txt:4: the file ends where output 2 of 3"},
        {"count too small", replaced(kExpected, "outputs=2", "outputs=1"), "expected.txt:3: more lines"},
        {"negative count", replaced(kExpected, "outputs=2", "outputs=-2"), "expected.txt:1: "},
        {"a number less", replaced(kExpected, "50 0", "50"), "expected.txt:2: "},
        {"a number more", replaced(kExpected, "50 0", "50 0 0"), "expected.txt:2: "},
        {"no pixels", replaced(kExpected, " pixels=1", ""), "expected.txt:1: "},
        {"disparity of three digits", replaced(kExpected, "ff", "100"),
         "expected.txt:2: \"100\" is not a word of 2 hex"},
        {"disparity of one digit", replaced(kExpected, "07", "7"), "expected.txt:3: \"7\" is not a word of 2 hex"},
        {"more digits than pixels", replaced(kExpectedOfTwo, "pixels=2", "pixels=1"),
         "expected.txt:2: \"0fff0001\" is not"},
        {"upper-case digits", replaced(kExpected, "ff", "FF"), "expected.txt:2: \"FF\" is not a word of 2 hex"},
        {"flags beyond 7", replaced(kExpected, "07 6", "07 8"), "expected.txt:3: flags are 8 but must be 0 ... 7"},
        {"disparities of 12 bits", replaced(kExpected, "bits=8", "bits=12"), "expected.txt:1: disparity_bits=12"},
        {"a letter", replaced(kExpected, "51", "5a"), "expected.txt:3: \"5a\" is not a number"}},
       expected_of);
}

TEST(VectorFiles, NamesTheFileThatCannotBeRead) {
   EXPECT_THROW(read_stimulus_file("no/such/stimulus.txt"), std::runtime_error);
   EXPECT_THROW(read_expected_file("no/such/expected.txt"), std::runtime_error);
}

}  // namespace
}  // namespace stereo::test
