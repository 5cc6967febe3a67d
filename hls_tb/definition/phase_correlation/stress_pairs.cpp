// SPDX-License-Identifier: Apache-2.0
#include "definition/phase_correlation/stress_pairs.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "definition/phase_correlation/reference_model.hpp"

namespace stereo::phase_correlation {
namespace {

constexpr int kResponses = 6;
constexpr int kRounds = 3;               // in which each filter comes once
constexpr int kWaves = 3;                // pairs of them
constexpr int kWhole = 100, kMost = 80;  // in a hundred: pixels that match

/// What the image of one filter is made of: as large as the filter.
struct Pattern {
   int side;
   std::vector<int> weights;  ///< of the filter; the grey value is the largest where they are positive
};

Pattern pattern_of(int scale, int response) {
   const int side = reach_before(scale) + 1 + reach_after(scale);
   Pattern pattern{side, {}};
   DeepImage impulse(side, side);
   for (int y = 0; y < side; ++y)
      for (int x = 0; x < side; ++x) {
         impulse.at(x, y) = 1;
         pattern.weights.push_back(
             responses(impulse, reach_before(scale), reach_before(scale), scale)[std::size_t(response)]);
         impulse.at(x, y) = 0;
      }
   return pattern;
}

/// All of a scale, for the largest and the smallest response.
std::vector<Pattern> patterns_of(int scale) {
   std::vector<Pattern> all;
   for (int response = 0; response < kResponses; ++response) {
      all.push_back(pattern_of(scale, response));
      all.push_back(all.back());
      for (int& weight : all.back().weights) weight = -weight;
   }
   return all;
}

/// Fills an image with whole patterns side by side, from number `next` on, and with parts of them at its ends. The grey
/// value is any where the weight is 0.
void draw(DeepImage& image, const std::vector<Pattern>& patterns, std::size_t& next, int top, Random& random) {
   const int side = patterns.front().side, columns = image.width / side;
   const int before = random.below(image.width - columns * side + 1);
   std::vector<const Pattern*> row(std::size_t(columns), nullptr);
   for (int y = 0; y < image.height; ++y) {
      if (y % side == 0 && y + side <= image.height)
         for (const Pattern*& pattern : row) pattern = &patterns[next++ % patterns.size()];
      for (int x = 0; x < image.width; ++x) {
         const int place = x - before + side;  // of a column that is one further
         const Pattern& pattern = *row[std::size_t(std::clamp(place / side - 1, 0, columns - 1))];
         const int weight = pattern.weights[std::size_t(y % side * side + place % side)];
         image.at(x, y) = uint16_t(weight > 0 ? top : weight < 0 ? 0 : random.below(top + 1));
      }
   }
}

/// Waves of each direction that has a filter, so short that the phases turn by nearly half a turn from a column to the
/// next: the codes beside a pixel are its opposite.
void draw_waves(DeepImage& image, int top, Random& random) {
   constexpr int kDirections = 3;
   const double across = random.between(0.36, 0.46), down = random.between(0.1, 0.4);  // periods a pixel
   std::array<double, kDirections> phases;
   for (double& phase : phases) phase = random.between(0, 1);
   for (int y = 0; y < image.height; ++y)
      for (int x = 0; x < image.width; ++x) {
         double sum = 0;
         for (int i = 0; i < kDirections; ++i)
            sum += std::cos(2 * std::numbers::pi * (across * x + (i - 1) * down * y + phases[std::size_t(i)]));
         image.at(x, y) = uint16_t(std::lround((sum / kDirections + 1) / 2 * top));
      }
}

void draw_noise(DeepImage& image, int top, Random& random) {
   for (uint16_t& pixel : image.pixels) pixel = uint16_t(random.below(top + 1));
}

/// So many pixels in a hundred of one image match those of the other one at a disparity.
void match(DeepPair& pair, int disparity, bool is_left, int share, Random& random) {
   for (int y = 0; y < pair.left.height; ++y)
      for (int x = std::max(0, -disparity); x < std::min(pair.left.width, pair.left.width - disparity); ++x) {
         if (!random.percent(share)) continue;
         if (is_left) pair.left.at(x + disparity, y) = pair.right.at(x, y);
         else pair.right.at(x, y) = pair.left.at(x + disparity, y);
      }
}

}  // namespace

std::vector<DeepPair> own_stress_pairs(const Matching& matching, int width, int height, Random& random) {
   std::vector<DeepPair> made;
   const int top = (1 << matching.pixel_bits) - 1;
   const auto any_disparity = [&] { return matching.min_disparity + random.below(matching.disparities); };
   for (int scale = 0; scale < matching.phase_scales; ++scale) {
      std::vector<Pattern> patterns = patterns_of(scale);
      const int side = patterns.front().side;
      if (width < side || height < side) continue;  // no pixel has a code of this scale
      const int of_image = width / side * (height / side), images = (int(patterns.size()) + of_image - 1) / of_image;
      for (int round = 0; round < kRounds; ++round) {
         shuffle(patterns, random);
         std::size_t left = 0, right = std::size_t(random.below(int(patterns.size())));
         for (int i = 0; i < images; ++i) {
            DeepPair pair{DeepImage(width, height), DeepImage(width, height)};
            draw(pair.left, patterns, left, top, random);
            draw(pair.right, patterns, right, top, random);
            if (round > 0) match(pair, any_disparity(), round == 1, kMost, random);
            made.push_back(std::move(pair));
         }
      }
   }
   if (made.empty()) return made;
   for (int i = 0; i < kWaves; ++i) {
      DeepPair pair{DeepImage(width, height), DeepImage(width, height)};
      draw_noise(pair.left, top, random);
      draw_waves(pair.right, top, random);
      match(pair, any_disparity(), true, kWhole, random);
      made.push_back(std::move(pair));
   }
   return made;
}

}  // namespace stereo::phase_correlation
