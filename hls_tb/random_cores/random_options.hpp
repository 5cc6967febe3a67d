// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <type_traits>

#include "scene/random.hpp"
#include "support/options.hpp"

namespace stereo {

/// The visitor that gives each choice of a list a random value.
struct RandomChoices {
   Random& random;

   void operator()(const char*, int, int, int, const char*) {}
   template <class Choice>
   void operator()(const char*, Choice& value) {
      value = Choice(random.below(int(std::size(Words<Choice>::kWords))));
   }
};

/// The visitor that gives each number of a list a random value within its limits. Of few values each is as likely, of
/// many the small ones are more likely.
struct RandomNumbers {
   Random& random;

   void operator()(const char*, int& value, int low, int high, const char*) {
      constexpr int kReach = 96;        // beyond that, cores only grow
      constexpr int kFarBelow = -1000;  // a number without a least value is drawn around its default
      if (high < low) return;           // limits that follow from another option's bad value
      const long long span = static_cast<long long>(high) - low;
      if (span < kReach) {
         value = low + random.below(int(span) + 1);
         return;
      }
      if (random.percent(8)) return;
      const int step = int(std::exp(random.between(0, std::log(kReach + 1)))) - 1;
      const bool downward = low <= kFarBelow && random.percent(50);
      const long long start = low > kFarBelow ? low : value;
      value = int(std::clamp<long long>(start + (downward ? -step : step), low, high));
   }
   template <class Choice>
   void operator()(const char*, const Choice&) {}
};

/// The visitor that writes the options that differ from `plain` as assignments of a row (support/configuration.hpp).
struct RowWriter {
   std::string text;

   void add(const std::string& name, const std::string& value) {
      text += (text.empty() ? "" : ", ") + name + " = " + value;
   }
   void operator()(const char* name, int value, int, int, const char*) { add(name, std::to_string(value)); }
   template <class Choice>
   void operator()(const char* name, const Choice& value) {
      const std::string word = Words<Choice>::kWords[std::size_t(value)];
      add(name, std::is_same_v<Choice, bool> ? word : std::string(Words<Choice>::kName) + "::" + word);
   }
};

/// Pixels of the images that a test takes.
template <class Config>
constexpr int largest_image() {
   if constexpr (requires { Config::kLeastPixels; }) return 3 * Config::kLeastPixels;
   else return 1500;
}

/// Whether a core of the configuration can be built, and is small enough for a test.
template <class Config>
bool can_be_tested(const Config& config) {
   if (config.width_px * config.height_px > largest_image<Config>() || !config.problem().empty()) return false;
   constexpr int kLargestRange = 40;
   if constexpr (requires { config.disparities; }) return config.disparities <= kLargestRange;
   else return true;
}

/// Whether one of four configurations is to have several clocks a pixel pair, which few random numbers allow.
template <class Config>
bool draws_folded(Random& random) {
   if constexpr (requires { &Config::is_folded; }) return random.percent(25);
   else return false;
}

/// Gives it several clocks a pixel pair, and what must go with them.
template <class Config>
void fold(Config& config, Random& random) {
   constexpr int kMostClocks = 8, kMostDisparities = 5;  // disparities of a pass or a phase
   if constexpr (requires { &Config::is_folded; }) {
      config.clocks_per_pixel = 2 + random.below(kMostClocks - 1);
      config.disparities = config.clocks_per_pixel * (2 + random.below(kMostDisparities - 1));
      config.pixels_per_clock = 1;
      config.front_clocks = config.clocks_per_pixel < 3 ? 1 : 1 + random.below(2);
      config.sign_memory = config.run_time_size = false;
   }
   if constexpr (requires { &Config::pass_disparities; }) {
      config.full_width = false;
   }
   if constexpr (requires { &Config::phase_disparities; }) {
      config.aggregation = Aggregation::direct;
   }
}

/// A configuration that its core takes, as the assignments of a row. The choices come first, so that each is as
/// frequent as the others, however few numbers go with it.
template <class Config>
std::string random_row(Random& random) {
   constexpr int kTries = 1000;
   const bool is_folded = draws_folded<Config>(random);
   while (true) {
      Config choices;
      RandomChoices draw_choices{random};
      Config::options(choices, draw_choices);
      for (int i = 0; i < kTries; ++i) {
         Config config = choices;
         RandomNumbers draw_numbers{random};
         Config::options(config, draw_numbers);
         if (is_folded) fold(config, random);
         if (!can_be_tested(config)) continue;
         RowWriter row;
         Config::options(config, row);
         return row.text;
      }
   }
}

}  // namespace stereo
