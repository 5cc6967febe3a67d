// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "block_matching/matching.hpp"

namespace stereo::semi_global {

struct Paths {
   bool path_left = true;   ///< along the row, from its left end
   bool path_right = true;  ///< along the row, from its right end
   bool path_above = true;  ///< down the column
   int p1 = 5;              ///< penalty of a step by one disparity, 0 ... 4095
   int p2 = 22;             ///< penalty of any other step, 0 ... 4095
   int p2_least = -1;  ///< along rows, P2 falls with the grey difference, down to this; -1, or P2 and more: it does not
   int above_p1 = -1;  ///< P1 of the path from above, 0 ... 4095; -1: p1
   int above_p2 = -1;  ///< P2 of the path from above, 0 ... 4095; -1: p2

   /// By how much P2 falls at most along a row; 0: it is the same everywhere.
   constexpr int largest_relief() const {
      return p2_least < 0 || p2_least >= p2 || !(path_left || path_right) ? 0 : p2 - p2_least;
   }
   constexpr bool has_relief() const { return largest_relief() > 0; }
   constexpr bool has_penalties_above() const { return path_above && (above_p1 >= 0 || above_p2 >= 0); }
   constexpr int p1_above() const { return above_p1 < 0 ? p1 : above_p1; }
   constexpr int p2_above() const { return above_p2 < 0 ? p2 : above_p2; }

   template <class Self, class Visitor>
   static constexpr void options(Self& self, Visitor& visit) {
      visit("path_left", self.path_left);
      visit("path_right", self.path_right);
      visit("path_above", self.path_above);
      visit("p1", self.p1, 0, 4095, "the penalty P1");
      visit("p2", self.p2, 0, 4095, "the penalty P2");
      visit("p2_least", self.p2_least, -1, 4095, "the least P2");
      visit("above_p1", self.above_p1, -1, 4095, "the penalty P1 from above");
      visit("above_p2", self.above_p2, -1, 4095, "the penalty P2 from above");
   }
   template <class Self>
   static constexpr Sentence problem(const Self& self) {
      if (!self.path_left && !self.path_right && !self.path_above) return "at least one path must be on";
      return {};
   }
};

/// The check against the runner-up.
struct UniquenessDistance {
   int uniqueness_distance = 0;  ///< least distance of the runner-up's sum, 0 ... 4095; 0: no check

   static constexpr int kLargestUniqueness = 4095;

   constexpr bool has_uniqueness_check() const { return uniqueness_distance > 0; }

   template <class Self, class Visitor>
   static constexpr void options(Self& self, Visitor& visit) {
      visit("uniqueness_distance", self.uniqueness_distance, 0, kLargestUniqueness, "the uniqueness distance");
   }
};

/// What semi-global matching computes: docs/algorithm.md defines each option. Models take it with images of any size.
struct Matching : OptionGroups<DisparityCount, MatchingWindow, SmallestDisparity, PixelFormat, ReferenceImage,
                               Default<Comparison{Cost::census}>, CensusWindow, Prefiltering, CostScale, Paths, TieRule,
                               LeftRightThreshold, UniquenessDistance, SubpixelSteps, MedianFilter, FullWidth,
                               BorderCost, PostProcessing> {
   using OptionGroups::OptionGroups;

   static constexpr int kLeastDisparities = 2;

   /// Any of them: without one every pixel is valid.
   constexpr bool has_check() const {
      return has_left_right_check() || has_uniqueness_check() || has_border_cost() || has_support_filter() ||
             window_costs().has_lost_pixels();
   }

   /// P2 falls by the grey difference of two neighbours over 2^relief_shift().
   constexpr int relief_shift() const { return pixel_bits - 7; }

   /// Columns by which the fresh start of a row path looks back: what the core's pipeline needs. It is part of the
   /// definition, since the sums depend on it.
   constexpr int look_back_columns() const {
      int levels = 0;
      while (1 << levels < disparities) ++levels;
      return levels + 4;
   }

   /// Block matching whose window costs are the ones here.
   constexpr block_matching::Matching window_costs() const { return shared_options<block_matching::Matching>(*this); }

   /// Why nothing can be matched with these options; empty when it can.
   constexpr Sentence problem() const {
      if (const Sentence sentence = problem_of(*this); !sentence.empty()) return sentence;
      if (full_width && window_px < 3) return "a semi-global map of full width needs a window of 3x3 pixels or more";
      return {};
   }
};

}  // namespace stereo::semi_global
