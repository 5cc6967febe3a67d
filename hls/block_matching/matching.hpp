// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "support/matching_groups.hpp"

namespace stereo::block_matching {

/// The check for texture in the prefiltered window.
struct TextureThreshold {
   int texture_threshold = 0;  ///< 0 ... prefilter_cap * window_px^2; 0: no check

   constexpr bool has_texture_check() const { return texture_threshold > 0; }

   template <class Self, class Visitor>
   static constexpr void options(Self& self, Visitor& visit) {
      visit("texture_threshold", self.texture_threshold, 0, largest(self), "the texture threshold");
   }
   template <class Self>
   static constexpr Sentence problem(const Self& self) {
      if (self.has_texture_check() && self.prefilter != Prefilter::xsobel)
         return "the texture check needs the prefilter";
      return {};
   }

  private:
   /// Of a window; without the prefilter there is no check whose threshold could be too high.
   template <class Self>
   static constexpr int largest(const Self& self) {
      if (self.prefilter == Prefilter::none || self.prefilter_cap < 1 || self.window_px < 1 ||
          self.window_px > kUnlimited / self.prefilter_cap / self.window_px)
         return kUnlimited;
      return self.prefilter_cap * self.window_px * self.window_px;
   }
};

/// What block matching computes: docs/algorithm.md defines each option. Models take it with images of any size.
struct Matching : OptionGroups<DisparityCount, MatchingWindow, SmallestDisparity, PixelFormat, ReferenceImage,
                               Comparison, CensusWindow, Prefiltering, TieRule, LeftRightThreshold, UniquenessPercent,
                               TextureThreshold, SubpixelSteps, MedianFilter, FullWidth, PostProcessing> {
   using OptionGroups::OptionGroups;

   /// Any of them: without one every pixel is valid.
   constexpr bool has_check() const {
      return has_left_right_check() || has_uniqueness_check() || has_texture_check() || has_lost_pixels() ||
             has_support_filter();
   }
   /// With full_width: some pixels at an end of a row have no candidate in the other image.
   constexpr bool has_lost_pixels() const {
      return full_width && (min_disparity + first_disparity > 0 || min_disparity + last_searched() < 0 ||
                            first_disparity > last_searched());
   }
   constexpr int last_searched() const { return last_disparity < 0 ? disparities - 1 : last_disparity; }
   constexpr bool searches_all() const { return first_disparity == 0 && last_searched() == disparities - 1; }

   /// Why nothing can be matched with these options; empty when it can.
   constexpr Sentence problem() const { return problem_of(*this); }
};

}  // namespace stereo::block_matching
