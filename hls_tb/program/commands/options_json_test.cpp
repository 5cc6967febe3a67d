// SPDX-License-Identifier: Apache-2.0
#include "program/commands/options_json.hpp"

#include <gtest/gtest.h>

#include "definition/block_matching/models.hpp"
#include "program/errors.hpp"

namespace stereo::app {
namespace {

const block_matching::Matching kPlainOptions{DisparityCount{16}};

std::shared_ptr<const Algorithm> algorithm(const block_matching::Matching& matching) {
   return std::make_shared<AlgorithmOf<block_matching::Matching>>(matching);
}

const std::shared_ptr<const Algorithm> kPlain = algorithm(kPlainOptions);

std::string sentence(const std::string& setting) {
   try {
      with_options(kPlain, {setting});
   } catch (const InputError& problem) {
      return problem.what();
   }
   return "";
}

TEST(Options, EveryNameOfTheJsonCanBeSet) {
   const block_matching::Matching others{DisparityCount{20},
                                         MatchingWindow{7},
                                         SmallestDisparity{-3},
                                         PixelFormat{10},
                                         ReferenceImage{Reference::left},
                                         Comparison{Cost::ssd},
                                         CensusWindow{.census_width_px = 7, .census_height_px = 3, .census_pattern = CensusPattern::sparse},
                                         Prefiltering{.prefilter = Prefilter::xsobel, .prefilter_cap = 9},
                                         TieRule{Ties::largest},
                                         LeftRightThreshold{2},
                                         UniquenessPercent{8},
                                         block_matching::TextureThreshold{4},
                                         SubpixelSteps{true},
                                         MedianFilter{true},
                                         FullWidth{.full_width = true, .first_disparity = 2, .last_disparity = 9},
                                         PostProcessing{.support_threshold = 9,
                                                        .confidence = true,
                                                        .margin_shift = 1,
                                                        .margin_weight = 3,
                                                        .support_weight = 5,
                                                        .fill_holes = true}};
   const nlohmann::json wanted = options_json(algorithm(others)->options()), plain = options_json(kPlain->options());
   ASSERT_EQ(wanted.size(), 26u);
   std::vector<std::string> settings;
   for (const auto& [name, value] : wanted.items()) {
      EXPECT_NE(value, plain[name]) << name << " must differ for this test to see it";
      settings.push_back(name + "=" + (value.is_string() ? value.get<std::string>() : value.dump()));
   }
   EXPECT_EQ(options_json(with_options(kPlain, settings)->options()), wanted);
}

TEST(Options, TheLastSettingWins) {
   EXPECT_EQ(options_json(with_options(kPlain, {"cost=census", "window_px=9"})->options())["window_px"], 9);
}

TEST(Options, RefusesWhatItDoesNotKnow) {
   for (const auto& [setting, words] : {std::pair{"window_px", "NAME=VALUE"},
                                        {"window=9", "no such option; known are: disparities"},
                                        {"window_px=", "a whole number"},
                                        {"window_px=9x", "a whole number"},
                                        {"window_px=99999999999", "a whole number"},
                                        {"window_px=1.5", "a whole number"},
                                        {"cost=SAD", "sad or ssd or census"},
                                        {"median=1", "false or true"},
                                        {"=", "no such option"},
                                        {"", "NAME=VALUE"}}) {
      EXPECT_NE(sentence(setting).find(words), std::string::npos) << sentence(setting);
      EXPECT_EQ(sentence(setting).find("--set " + std::string(setting)), 0u);
   }
}

}  // namespace
}  // namespace stereo::app
