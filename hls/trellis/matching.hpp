// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "semi_global/matching.hpp"

namespace stereo::trellis {

struct Drops {
   int drop_cost = 4;          ///< gamma: of a disparity that falls, 0 ... 255
   int occlusion_cost = 7;     ///< omega: of a pixel that has no partner, 1 ... 255
   int far_drop = 6;           ///< s: disparities that a far drop falls by, 2 ... 255; from D on there is none
   bool mark_occluded = true;  ///< occluded pixels are not valid

   template <class Self, class Visitor>
   static constexpr void options(Self& self, Visitor& visit) {
      visit("drop_cost", self.drop_cost, 0, 255, "the cost of a drop");
      visit("occlusion_cost", self.occlusion_cost, 1, 255, "the cost of an occluded pixel");
      visit("far_drop", self.far_drop, 2, 255, "the far drop");
      visit("mark_occluded", self.mark_occluded);
   }
};

/// What the trellis computes: docs/algorithm.md defines each option. The reference is the left image. Models take it
/// with images of any size.
struct Matching
    : OptionGroups<DisparityCount, MatchingWindow, SmallestDisparity, PixelFormat, Default<Comparison{Cost::census}>,
                   CensusWindow, Prefiltering, CostScale, Drops, MedianFilter, PostProcessing> {
   using OptionGroups::OptionGroups;

   static constexpr int kLeastDisparities = 2;

   /// Any of them: without one every pixel is valid.
   constexpr bool has_check() const { return mark_occluded || has_support_filter(); }

   /// Semi-global matching whose costs are the ones here.
   constexpr semi_global::Matching path_costs() const {
      semi_global::Matching matching = shared_options<semi_global::Matching>(*this);
      matching.reference = Reference::left;
      matching.confidence = false;  // paths of the trellis have no runner-up
      return matching;
   }

   /// Why nothing can be matched with these options; empty when it can.
   constexpr Sentence problem() const { return problem_of(*this); }
};

}  // namespace stereo::trellis
