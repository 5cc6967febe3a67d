// SPDX-License-Identifier: Apache-2.0
#include "block_matching/config.hpp"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "block_matching/configurations.hpp"
#include "block_matching/core.hpp"
#include "definition/block_matching/matching_input.hpp"
#include "testing/test_configs.hpp"

namespace stereo::test {
namespace {

TEST(BlockMatchingConfig, AmbroschIsThePapersConfiguration) {
   constexpr block_matching::Config C = block_matching::configurations::ambrosch2007;
   EXPECT_EQ(C.width_px, 320);
   EXPECT_EQ(C.height_px, 240);
   EXPECT_EQ(C.disparities, 100);
   EXPECT_EQ(C.window_px, 3);
   EXPECT_EQ(C.output_width_px(), 220);
   EXPECT_EQ(C.output_height_px(), 240);
   EXPECT_EQ(C.largest_window_cost(), 9 * 255);
   EXPECT_EQ(C.disparity_bits(), 8);
}

/// By definition: the lowest window of a group of P rows ends rows_below below it; all of them cover P + B - 1 rows, of
/// which the newest group gives those that it holds. Recursive sums need the row above them, too.
TEST(BlockMatchingConfig, RowsOfTheWindowsFollowFromTheirSide) {
   for (const Aggregation aggregation : {Aggregation::direct, Aggregation::recursive})
      for (const int window : {2, 3, 4, 5, 8, 31})
         for (const int pixels : {1, 2, 4}) {
            const block_matching::Config config{{.width_px = 64, .height_px = 48, .pixels_per_clock = pixels},
                                                {DisparityCount{32}, MatchingWindow{window}},
                                                {Summation{aggregation}}};
            SCOPED_TRACE(config_name(config));
            int above = 0, below = 0;  // rows beside the centre: of an even window one more above
            for (int row = 1; row < window; ++row) ++(row % 2 == 1 ? above : below);
            EXPECT_EQ(config.rows_above(), above);
            EXPECT_EQ(config.rows_below(), below);
            int delay = 0;
            while (delay * pixels < below) ++delay;
            EXPECT_EQ(config.delay_groups(), delay);
            EXPECT_EQ(config.row_groups(), 48 / pixels);
            const std::vector<int> taps = tap_offsets(config);
            ASSERT_EQ(config.tap_rows(), int(taps.size()));
            for (std::size_t t = 0; t < taps.size(); ++t) EXPECT_EQ(config.top_row() + config.tap_row(int(t)), taps[t]);
            const int newest_group = delay * pixels;  // seen from the first row of the windows' centres
            EXPECT_EQ(config.stored_rows(), newest_group - taps[0]);
         }
}

TEST(BlockMatchingConfig, TheSizeOfTheMapIsThatOfTheModels) {
   for (const Reference reference : {Reference::right, Reference::left})
      for (int min_disparity = -40; min_disparity <= 20; ++min_disparity)
         for (const bool full_width : {false, true}) {
            const block_matching::Config config{
                {.width_px = 50, .height_px = 20},
                {DisparityCount{10}, MatchingWindow{4}, SmallestDisparity{min_disparity}, ReferenceImage{reference},
                 FullWidth{.full_width = full_width}},
                {}};
            const block_matching::Matching& parameters = config;
            SCOPED_TRACE(config_name(config));
            EXPECT_EQ(config.cost_columns(), cost_columns(50, parameters));
            EXPECT_EQ(config.output_width_px(), map_width(50, parameters));
            EXPECT_EQ(config.output_first_column(), map_first_column(parameters));
         }
}

TEST(BlockMatchingConfig, WidthsFollowFromThePixels) {
   block_matching::Config config{{.width_px = 32, .height_px = 12}, {DisparityCount{8}, PixelFormat{12}}, {}};
   EXPECT_EQ(config.feature_bits(), 12);
   EXPECT_EQ(config.largest_window_cost(), 4095 * 9);
   config.prefilter = Prefilter::xsobel;
   config.prefilter_cap = 63 << 4;
   EXPECT_EQ(config.problem().text, std::string());
   EXPECT_EQ(config.feature_bits(), bits_for(2 * config.prefilter_cap));
   ++config.prefilter_cap;
   EXPECT_EQ(config.problem().text, std::string("the prefilter's cap is 1009 but must be 1 ... 1008"));
}

TEST(BlockMatchingConfig, SaysWhichPixelsItDoesNotTake) {
   block_matching::Config config{{.width_px = 32, .height_px = 32}, {DisparityCount{16}}, {}};
   config.pixel_bits = 9;
   EXPECT_EQ(config.problem().text, std::string("the number of bits of a pixel is 9 but must be 8, 10 or 12"));
   config.pixel_bits = 16;
   EXPECT_EQ(config.problem().text, std::string("the number of bits of a pixel is 16 but must be 8 ... 12"));
   config.pixel_bits = 12;
   config.window_px = 31;
   config.cost = Cost::ssd;
   EXPECT_EQ(config.problem().text, std::string("window costs must stay below 2^26"));
   config.cost = Cost::sad;
   config.prefilter = Prefilter::xsobel;
   config.window_px = 9;
   config.prefilter_cap = 1000;
   config.texture_threshold = 100;
   config.run_time_settings = true;
   EXPECT_EQ(config.problem().text,
             std::string("with run-time settings prefilter_cap * window_px^2 must stay below 2^16"));
}

TEST(BlockMatchingConfig, SaysWhichSizesARunTimeSizeCanHave) {
   block_matching::Config config{
       {.width_px = 640, .height_px = 480, .pixels_per_clock = 2}, {DisparityCount{64}, MatchingWindow{9}}, {}};
   config.run_time_size = true;
   EXPECT_EQ(config.problem().text, std::string());
   EXPECT_EQ(least_size(config).width_px, 63 + 9);
   EXPECT_EQ(least_size(config).height_px, 10);
   for (const auto& [width, height] : {std::pair(63 + 9, 10), std::pair(640, 10), std::pair(63 + 9, 480)}) {
      block_matching::Config smaller = config;
      smaller.width_px = width;
      smaller.height_px = height;
      EXPECT_EQ(smaller.problem().text, std::string()) << width << "x" << height;
   }
   config.width_px = 63 + 8;
   const std::string too_small =
       "with a run-time size all disparities must fit at as many columns as the window has, and the image must have "
       "two groups of rows";
   EXPECT_EQ(config.problem().text, too_small);
   // What a map of full width has beside these columns makes no difference.
   config.full_width = true;
   EXPECT_EQ(config.problem().text, too_small);
   config.width_px = 640;
   EXPECT_EQ(config.problem().text, std::string());
   EXPECT_EQ(least_size(config).width_px, 63 + 9);
   EXPECT_EQ(least_size(config).height_px, 10);
   // A map of one column has its first median behind the line's end: not where the width comes from ports.
   config.full_width = false;
   config.window_px = 2;
   EXPECT_EQ(least_size(config).width_px, 63 + 2);
   config.median = true;
   EXPECT_EQ(least_size(config).width_px, 63 + 3);
   config.width_px = 63 + 2;
   EXPECT_EQ(config.problem().text, std::string("with a run-time size and a median the map must have two columns"));
}

TEST(BlockMatchingConfig, SaysWhereAMapOfFullWidthIsNone) {
   block_matching::Config config{
       {.width_px = 20, .height_px = 30}, {DisparityCount{10}, FullWidth{.full_width = true}}, {}};
   EXPECT_EQ(config.problem().text, std::string());
   config.window_px = 20;
   EXPECT_EQ(config.problem().text, std::string("with a map of full width the image must be wider than the window"));
   config.window_px = 1;
   EXPECT_EQ(config.problem().text, std::string("a map of full width needs a window of 2x2 pixels or more"));
   EXPECT_FALSE(config.has_check()) << "disparity 0 is a candidate of every pixel";
   config.min_disparity = 1;
   EXPECT_TRUE(config.has_check());
   config.min_disparity = -10;
   EXPECT_TRUE(config.has_check());
   config.min_disparity = -9;
   EXPECT_FALSE(config.has_check());
   config.last_disparity = 8;
   EXPECT_TRUE(config.has_check()) << "the last column leads out of the image with what is searched";
   config.last_disparity = 10;
   config.window_px = 3;
   EXPECT_EQ(config.problem().text, std::string("the last disparity is 10 but must be -1 ... 9"));
   config.last_disparity = -1;
   config.run_time_settings = true;
   EXPECT_EQ(config.problem().text, std::string());
   EXPECT_TRUE(config.has_check()) << "the ports may leave any disparity out";
   config = {{.width_px = 20, .height_px = 30}, {DisparityCount{10}, FullWidth{.first_disparity = 1}}, {}};
   EXPECT_EQ(config.problem().text, std::string("first_disparity and last_disparity need a map of full width"));
}

TEST(BlockMatchingConfig, SaysWhatSeveralClocksAPixelCannotBeCombinedWith) {
   using Config = block_matching::Config;
   const auto problem = [](auto change) {
      Config config{{.width_px = 48, .height_px = 12}, {DisparityCount{8}}, {Folding{4}}};
      change(config);
      return std::string(config.problem().text);
   };
   EXPECT_EQ(problem([](Config&) {}), "");
   EXPECT_EQ(problem([](Config& c) { c.clocks_per_pixel = 3; }),
             "the clocks a pixel pair must divide the disparity range");
   EXPECT_EQ(problem([](Config& c) { c.clocks_per_pixel = 8; }),
             "with several clocks a pixel pair two disparities or more must be left for each");
   EXPECT_EQ(problem([](Config& c) { c.clocks_per_pixel = 0; }),
             "the number of clocks a pixel pair is 0 but must be 1 ... 128");
   EXPECT_EQ(problem([](Config& c) { c.pixels_per_clock = 2; }),
             "with several clocks a pixel pair only one comes at once");
   EXPECT_EQ(problem([](Config& c) { c.sign_memory = true; }),
             "with several clocks a pixel pair there is no sign memory");
   EXPECT_EQ(problem([](Config& c) { c.full_width = true; }),
             "with several clocks a pixel pair there is no map of full width");
   EXPECT_EQ(problem([](Config& c) { c.run_time_size = true; }),
             "with several clocks a pixel pair there is no run-time size");
   EXPECT_EQ(problem([](Config& c) { c.support_threshold = 4; }), "");
   EXPECT_EQ(problem([](Config& c) { c.front_clocks = 2; }), "");
   EXPECT_EQ(problem([](Config& c) {
                c.clocks_per_pixel = 2;
                c.front_clocks = 2;
             }),
             "with two clocks of the comparisons in front a pixel pair must take three clocks or more");
   EXPECT_EQ(problem([](Config& c) { c.front_clocks = 3; }),
             "the number of clocks of the comparisons in front is 3 but must be 1 ... 2");
   EXPECT_EQ(problem([](Config& c) { c.width_px = 12; }),
             "with so many clocks a pixel pair the image must be wider for its passes to fit in a row");
}

/// A pass reads what the pass before it wrote: these images are the widest that were wrong and the narrowest right
/// ones.
TEST(BlockMatchingConfig, PassesAreApart) {
   using block_matching::Config;
   const auto takes = [](int width, int disparities, int min_disparity, int left_right_threshold) {
      Config c;
      c.width_px = width;
      c.height_px = 4;
      c.window_px = 2;
      c.clocks_per_pixel = 6;
      c.disparities = disparities;
      c.min_disparity = min_disparity;
      c.left_right_threshold = left_right_threshold;
      return c.problem().empty();
   };
   EXPECT_FALSE(takes(14, 12, 0, -1));
   EXPECT_TRUE(takes(15, 12, 0, -1));
   EXPECT_FALSE(takes(33, 30, -8, 0));
   EXPECT_TRUE(takes(34, 30, -8, 0));
}

/// Plain core: the last window needs the rows below it, then the columns of its row that come after it.
TEST(BlockMatchingConfig, FlushGroupsBringOutTheLastDisparity) {
   using block_matching::Core;
   EXPECT_EQ(Core<block_matching::configurations::ambrosch2007>::kSchedule.flush_groups, 320);
   EXPECT_EQ(Core<block_matching::configurations::tiny>::kSchedule.flush_groups, 32);
   // No row and no column below its centre, and the map lacks the last column.
   static constexpr block_matching::Config kSmallWindow{{32, 12}, {DisparityCount{8}, MatchingWindow{2}}, {}};
   EXPECT_EQ(Core<kSmallWindow>::kSchedule.flush_groups, 0);
   static constexpr block_matching::Config kOfTheLeft{
       {32, 12}, {DisparityCount{8}, MatchingWindow{2}, ReferenceImage{Reference::left}}, {}};
   EXPECT_EQ(Core<kOfTheLeft>::kSchedule.flush_groups, 1);
}

TEST(BlockMatchingConfig, LargestCosts) {
   EXPECT_EQ(
       (block_matching::Config{{.width_px = 320, .height_px = 240}, {DisparityCount{64}, Comparison{Cost::ssd}}, {}})
           .largest_pixel_cost(),
       65025);
   EXPECT_EQ(
       (block_matching::Config{{.width_px = 320, .height_px = 240}, {DisparityCount{64}, Comparison{Cost::census}}, {}})
           .largest_pixel_cost(),
       24);
   EXPECT_EQ((block_matching::Config{{.width_px = 320, .height_px = 240},
                                     {DisparityCount{64}, Comparison{Cost::census},
                                      CensusWindow{.census_width_px = 9, .census_height_px = 7}},
                                     {}})
                 .largest_pixel_cost(),
             62);
   EXPECT_EQ((block_matching::Config{{.width_px = 320, .height_px = 240},
                                     {DisparityCount{64}, Prefiltering{.prefilter = Prefilter::xsobel}},
                                     {}})
                 .largest_pixel_cost(),
             62);
   EXPECT_EQ((block_matching::Config{{.width_px = 320, .height_px = 240},
                                     {DisparityCount{64}, Comparison{Cost::ssd},
                                      Prefiltering{.prefilter = Prefilter::xsobel, .prefilter_cap = 63}},
                                     {}})
                 .largest_pixel_cost(),
             126 * 126);
   EXPECT_EQ(
       (block_matching::Config{
            {.width_px = 320, .height_px = 240}, {DisparityCount{64}, MatchingWindow{31}, Comparison{Cost::ssd}}, {}})
           .largest_window_cost(),
       65025 * 961);
}

TEST(BlockMatchingConfig, OnlyTheRowsAtOnceTellThePapersConfigurationsApart) {
   EXPECT_EQ(block_matching::configurations::ambrosch2007.pixels_per_clock, 1);
   EXPECT_EQ(block_matching::configurations::ambrosch2007_p2.pixels_per_clock, 2);
   EXPECT_EQ(block_matching::configurations::ambrosch2007_p4.pixels_per_clock, 4);
   for (const block_matching::Config& config :
        {block_matching::configurations::ambrosch2007_p2, block_matching::configurations::ambrosch2007_p4}) {
      EXPECT_EQ(config.width_px, 320);
      EXPECT_EQ(config.height_px, 240);
      EXPECT_EQ(config.disparities, 100);
      EXPECT_EQ(config.window_px, 3);
   }
}

/// A change of the paper's configuration.
using Change = void (*)(block_matching::Config& c);

block_matching::Config changed(Change change) {
   block_matching::Config config = block_matching::configurations::ambrosch2007;
   config.sign_memory = false;  // it would be refused first
   change(config);
   return config;
}

TEST(BlockMatchingConfig, RefusesWhatTheBlocksCannotBuild) {
   const std::pair<Change, const char*> refused[] = {
       {[](auto& c) { c.width_px = 4097; }, "the image width is 4097 but must be 8 ... 4096"},
       {[](auto& c) { c.width_px = 7, c.disparities = 4; }, "the image width is 7 but must be 8 ... 4096"},
       {[](auto& c) { c.height_px = 2; }, "the image height must be window_px ... 4096 pixels"},
       {[](auto& c) { c.height_px = 4097; }, "the image height is 4097 but must be 1 ... 4096"},
       {[](auto& c) { c.window_px = 1; }, "the matching window must be 2x2 ... 31x31 pixels"},
       {[](auto& c) { c.window_px = 32; }, "the matching window must be 2x2 ... 31x31 pixels"},
       {[](auto& c) { c.disparities = 257; }, "the disparity range is 257 but must be 1 ... 256"},
       {[](auto& c) { c.width_px = 100; }, "the image must be wider than the disparity range"},
       {[](auto& c) { c.min_disparity = 220; }, "the disparity range lies outside the image"},
       {[](auto& c) { c.min_disparity = -319; }, "the disparity range lies outside the image"},
       {[](auto& c) { c.disparities = 2, c.window_px = 5; }, "the disparity range must exceed the window's radius"},
       {[](auto& c) { c.disparities = 1; }, "the disparity range must be 2 ... 256"},
       {[](auto& c) { c.pixels_per_clock = 3; }, "the number of pixel pairs a clock is 3 but must be 1, 2 or 4"},
       {[](auto& c) { c.pixels_per_clock = 8; }, "the number of pixel pairs a clock is 8 but must be 1 ... 4"},
       {[](auto& c) { c.height_px = 238, c.pixels_per_clock = 4; },
        "the image height must be a multiple of the pixel pairs a clock"},
       {[](auto& c) { c.height_px = 4, c.pixels_per_clock = 4; },
        "the image must be higher than the rows that a window waits for"},
       {[](auto& c) { c.prefilter_cap = 0; }, "the prefilter's cap is 0 but must be 1 ... 63"},
       {[](auto& c) { c.prefilter_cap = 64; }, "the prefilter's cap is 64 but must be 1 ... 63"},
       {[](auto& c) { c.cost = Cost::census, c.prefilter = Prefilter::xsobel; },
        "the census transform takes no prefilter"},
       {[](auto& c) { c.left_right_threshold = -2; }, "the left/right threshold is -2 but must be -1 ... 99"},
       {[](auto& c) { c.left_right_threshold = 100; }, "the left/right threshold is 100 but must be -1 ... 99"},
       {[](auto& c) { c.uniqueness_percent = -1; }, "the uniqueness in percent is -1 but must be 0 ... 100"},
       {[](auto& c) { c.uniqueness_percent = 101; }, "the uniqueness in percent is 101 but must be 0 ... 100"},
       {[](auto& c) { c.uniqueness_percent = 1, c.cost = Cost::ssd, c.window_px = 17; },
        "with a uniqueness check window costs must stay below 2^24"},
       {[](auto& c) { c.texture_threshold = 1; }, "the texture check needs the prefilter"},
       {[](auto& c) { c.texture_threshold = -1; }, "the texture threshold is -1 but must be at least 0"},
       {[](auto& c) { c.texture_threshold = 280, c.prefilter = Prefilter::xsobel; },
        "the texture threshold is 280 but must be 0 ... 279"},
       {[](auto& c) { c.height_px = 3, c.cost = Cost::census, c.census_height_px = 7; },
        "the image must be higher than the rows that a transform waits for"},
       {[](auto& c) { c.height_px = 2, c.window_px = 2, c.pixels_per_clock = 2, c.median = true; },
        "the image must be higher than the row that a median waits for"},
       {[](auto& c) { c.slice_disparities = 1; }, "the number of disparities of a slice is 1 but must be at least 2"},
       {[](auto& c) { c.cost_clocks = 0; }, "the number of clocks of the cost is 0 but must be 1 ... 3"},
       {[](auto& c) { c.cost_clocks = 4; }, "the number of clocks of the cost is 4 but must be 1 ... 3"},
       {[](auto& c) { c.sign_memory = true, c.cost_clocks = 2; },
        "a sign memory needs direct SAD sums in 3 clocks, images of at least 8 columns, and no texture check"},
       {[](auto& c) { c.sign_memory = true, c.cost = Cost::census; },
        "a sign memory needs direct SAD sums in 3 clocks, images of at least 8 columns, and no texture check"},
       {[](auto& c) { c.sign_memory = true, c.aggregation = Aggregation::recursive; },
        "a sign memory needs direct SAD sums in 3 clocks, images of at least 8 columns, and no texture check"},
       {[](auto& c) { c.winner_group = 1; }, "the number of candidates of a winner group is 1 but must be 2 ... 16"},
       {[](auto& c) { c.winner_group = 17; }, "the number of candidates of a winner group is 17 but must be 2 ... 16"},
       {[](auto& c) { c.census_width_px = 1; }, "the census window's width is 1 but must be 3 ... 9"},
       {[](auto& c) { c.census_width_px = 4; }, "the census window is 4x5 but both sides must be odd"},
       {[](auto& c) { c.census_width_px = 11; }, "the census window's width is 11 but must be 3 ... 9"},
       {[](auto& c) { c.census_height_px = 1; }, "the census window's height is 1 but must be 3 ... 7"},
       {[](auto& c) { c.census_height_px = 6; }, "the census window is 5x6 but both sides must be odd"},
       {[](auto& c) { c.census_height_px = 9; }, "the census window's height is 9 but must be 3 ... 7"},
   };
   for (const auto& [change, sentence] : refused) EXPECT_STREQ(changed(change).problem().text, sentence);
}

TEST(BlockMatchingConfig, AcceptsTheNeighboursOfTheBordersAbove) {
   const Change accepted[] = {
       [](auto& c) { c.winner_group = 4; },
       [](auto& c) { c.width_px = 8, c.height_px = 2, c.disparities = 2, c.window_px = 2; },
       [](auto& c) { c.width_px = 4096, c.height_px = 4096, c.disparities = 256, c.window_px = 31; },
       [](auto& c) { c.min_disparity = 219; },
       [](auto& c) { c.min_disparity = -318; },
       [](auto& c) { c.uniqueness_percent = 100, c.cost = Cost::ssd, c.window_px = 16; },
   };
   for (const Change change : accepted) EXPECT_STREQ(changed(change).problem().text, "");
}

}  // namespace
}  // namespace stereo::test
