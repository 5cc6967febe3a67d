// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "block_matching/matching.hpp"

namespace stereo::phase_correlation {

struct PhaseScales {
   int phase_scales = 2;  ///< S, 1 ... 3: scales whose phases are compared

   template <class Self, class Visitor>
   static constexpr void options(Self& self, Visitor& visit) {
      visit("phase_scales", self.phase_scales, 1, 3, "the number of phase scales");
   }
};

/// What local weighted phase correlation computes: docs/algorithm.md defines each option. The matching window is that
/// of the local weighting. Models take it with images of any size.
struct Matching : OptionGroups<DisparityCount, Default<MatchingWindow{9}>, SmallestDisparity, PixelFormat,
                               ReferenceImage, PhaseScales, TieRule, LeftRightThreshold, UniquenessPercent,
                               SubpixelSteps, MedianFilter, FullWidth, PostProcessing> {
   using OptionGroups::OptionGroups;

   /// Any of them: without one every pixel is valid.
   constexpr bool has_check() const { return block_matching().has_check(); }

   /// Block matching that only differs in what it compares. Its census of 5x5 has the largest cost of three scales, 24.
   constexpr block_matching::Matching block_matching() const {
      block_matching::Matching matching = shared_options<block_matching::Matching>(*this);
      matching.cost = Cost::census;
      return matching;
   }

   /// Why nothing can be matched with these options; empty when it can.
   constexpr Sentence problem() const { return problem_of(*this); }
};

}  // namespace stereo::phase_correlation
