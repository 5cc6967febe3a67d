// SPDX-License-Identifier: Apache-2.0
// The options of what is computed that several families have; docs/algorithm.md defines each.
#pragma once

#include "support/matching_options.hpp"
#include "support/option_groups.hpp"

namespace stereo {

/// How many disparities are searched.
struct DisparityCount {
   int disparities = 64;  ///< disparity range D: 0 <= d < D, up to 256 and below the image width

   static constexpr int kLeastDisparities = 1;  ///< a family may have another

   template <class Self, class Visitor>
   static constexpr void options(Self& self, Visitor& visit) {
      visit("disparities", self.disparities, Self::kLeastDisparities, 256, "the disparity range");
   }
};

/// Where they begin.
struct SmallestDisparity {
   int min_disparity = 0;  ///< m: disparity d stands for m + d pixels

   static constexpr int kFarthest = 1 << 24;  ///< px: beyond any image, and far from where sums would overflow

   template <class Self, class Visitor>
   static constexpr void options(Self& self, Visitor& visit) {
      visit("min_disparity", self.min_disparity, -kFarthest, kFarthest, "the smallest disparity");
   }
};

struct MatchingWindow {
   int window_px = 3;  ///< side B of the square matching window, 1 or more, odd or even

   static constexpr int kLeastWindow = 1, kLargestWindow = kUnlimited;  ///< a family may have others

   template <class Self, class Visitor>
   static constexpr void options(Self& self, Visitor& visit) {
      visit("window_px", self.window_px, Self::kLeastWindow, Self::kLargestWindow, "the window side");
   }
};

struct PixelFormat {
   int pixel_bits = 8;  ///< grey values are 0 ... 2^pixel_bits - 1; 8, 10 or 12

   constexpr int largest_pixel() const { return (1 << pixel_bits) - 1; }

   template <class Self, class Visitor>
   static constexpr void options(Self& self, Visitor& visit) {
      visit("pixel_bits", self.pixel_bits, 8, 12, "the number of bits of a pixel");
   }
   template <class Self>
   static constexpr Sentence problem(const Self& self) {
      if (self.pixel_bits % 2 == 0) return {};
      Sentence sentence = "the number of bits of a pixel is ";
      return sentence << self.pixel_bits << " but must be 8, 10 or 12";
   }
};

/// Whose pixels get disparities.
struct ReferenceImage {
   Reference reference = Reference::right;

   template <class Self, class Visitor>
   static constexpr void options(Self& self, Visitor& visit) {
      visit("reference", self.reference);
   }
};

/// What a pair of pixels costs.
struct Comparison {
   Cost cost = Cost::sad;

   template <class Self, class Visitor>
   static constexpr void options(Self& self, Visitor& visit) {
      visit("cost", self.cost);
   }
};

struct CensusWindow {
   int census_width_px = 5;   ///< 3 ... 9, odd
   int census_height_px = 5;  ///< 3 ... 7, odd
   CensusPattern census_pattern = CensusPattern::all;

   template <class Self, class Visitor>
   static constexpr void options(Self& self, Visitor& visit) {
      visit("census_width_px", self.census_width_px, 3, 9, "the census window's width");
      visit("census_height_px", self.census_height_px, 3, 7, "the census window's height");
      visit("census_pattern", self.census_pattern);
   }
   template <class Self>
   static constexpr Sentence problem(const Self& self) {
      if (self.census_pattern == CensusPattern::sparse && self.census_width_px == 3 && self.census_height_px == 3)
         return "a sparse census of 3x3 has no pixel but its centre";
      if (self.census_width_px % 2 != 0 && self.census_height_px % 2 != 0) return {};
      Sentence sentence = "the census window is ";
      return sentence << self.census_width_px << "x" << self.census_height_px << " but both sides must be odd";
   }
};

/// Of families with a Comparison and a PixelFormat.
struct Prefiltering {
   Prefilter prefilter = Prefilter::none;
   int prefilter_cap = 31;  ///< 1 ... 63 * 2^(pixel_bits - 8); filtered pixels are 0 ... 2*cap

   template <class Self, class Visitor>
   static constexpr void options(Self& self, Visitor& visit) {
      visit("prefilter", self.prefilter);
      visit("prefilter_cap", self.prefilter_cap, 1, largest_cap(self.pixel_bits), "the prefilter's cap");
   }
   template <class Self>
   static constexpr Sentence problem(const Self& self) {
      if (self.cost == Cost::census && self.prefilter != Prefilter::none)
         return "the census transform takes no prefilter";
      return {};
   }

  private:
   /// The same share of the range of grey values for each width.
   static constexpr int largest_cap(int pixel_bits) {
      return pixel_bits < 8 || pixel_bits > 12 ? kUnlimited : 63 << (pixel_bits - 8);
   }
};

/// From window costs to those that paths or states see.
struct CostScale {
   int cost_shift = 4;   ///< window costs are divided by 2^cost_shift, 0 ... 16
   int cost_cap = 4095;  ///< the largest cost that is seen, 1 ... 4095

   template <class Self, class Visitor>
   static constexpr void options(Self& self, Visitor& visit) {
      visit("cost_shift", self.cost_shift, 0, 16, "the cost shift");
      visit("cost_cap", self.cost_cap, 1, 4095, "the cost cap");
   }
};

/// Which of several best disparities wins.
struct TieRule {
   Ties ties = Ties::smallest;

   template <class Self, class Visitor>
   static constexpr void options(Self& self, Visitor& visit) {
      visit("ties", self.ties);
   }
};

/// The check against the other image's disparities.
struct LeftRightThreshold {
   int left_right_threshold = -1;  ///< largest difference of a consistent pair of disparities, below D; -1: no check

   constexpr bool has_left_right_check() const { return left_right_threshold >= 0; }

   template <class Self, class Visitor>
   static constexpr void options(Self& self, Visitor& visit) {
      visit("left_right_threshold", self.left_right_threshold, -1, self.disparities - 1, "the left/right threshold");
   }
};

/// The check against the second best cost.
struct UniquenessPercent {
   int uniqueness_percent = 0;  ///< 0 ... 100; 0: no check

   constexpr bool has_uniqueness_check() const { return uniqueness_percent > 0; }

   template <class Self, class Visitor>
   static constexpr void options(Self& self, Visitor& visit) {
      visit("uniqueness_percent", self.uniqueness_percent, 0, 100, "the uniqueness in percent");
   }
};

struct SubpixelSteps {
   bool subpixel = false;  ///< disparities in sixteenths of a pixel

   template <class Self, class Visitor>
   static constexpr void options(Self& self, Visitor& visit) {
      visit("subpixel", self.subpixel);
   }
};

struct MedianFilter {
   bool median = false;  ///< median of 3x3 disparities

   template <class Self, class Visitor>
   static constexpr void options(Self& self, Visitor& visit) {
      visit("median", self.median);
   }
};

/// Of families with a DisparityCount and a MatchingWindow.
struct FullWidth {
   bool full_width = false;  ///< a disparity for every pixel whose window lies in the image
   int first_disparity = 0;  ///< with full_width: lowest of the disparities 0 ... D-1 that is searched
   int last_disparity = -1;  ///< and the highest one; -1: D-1

   /// Whether an option says which part is searched, be it all of it.
   constexpr bool names_a_part() const { return first_disparity != 0 || last_disparity != -1; }

   template <class Self, class Visitor>
   static constexpr void options(Self& self, Visitor& visit) {
      visit("full_width", self.full_width);
      const int highest = self.full_width ? self.disparities - 1 : 0;
      visit("first_disparity", self.first_disparity, 0, highest, "the first disparity");
      visit("last_disparity", self.last_disparity, -1, self.full_width ? highest : -1, "the last disparity");
   }
   template <class Self>
   static constexpr Sentence missing(const Self& self) {
      if (!self.full_width && self.names_a_part()) return "first_disparity and last_disparity need a map of full width";
      return {};
   }
   template <class Self>
   static constexpr Sentence problem(const Self& self) {
      if (self.full_width && self.window_px < 2) return "a map of full width needs a window of 2x2 pixels or more";
      return {};
   }
};

/// Of families with a map of full width: what a disparity costs whose partner lies outside the other image.
struct BorderCost {
   int border_cost = -1;  ///< 0 ... 4095, and then all disparities are candidates; -1: they are masked

   constexpr bool has_border_cost() const { return border_cost >= 0; }

   template <class Self, class Visitor>
   static constexpr void options(Self& self, Visitor& visit) {
      visit("border_cost", self.border_cost, -1, self.full_width ? 4095 : -1, "the border cost");
   }
   template <class Self>
   static constexpr Sentence missing(const Self& self) {
      if (!self.full_width && self.has_border_cost()) return "border_cost needs a map of full width";
      return {};
   }
};

/// From a map with holes to a depth map: a filter, a number that says how sure a disparity is, and the filled holes.
struct PostProcessing {
   int support_threshold = 0;  ///< least neighbours of 35 with about the same disparity, itself one; 0: no filter
   bool confidence = false;    ///< a number 0 ... 255 for each pixel; needs the filter
   int margin_shift = 0;       ///< of it: the runner-up's distance is divided by 2^margin_shift, 0 ... 16
   int margin_weight = 2;      ///< factor of that distance, of 63 at most, 0 ... 8
   int support_weight = 4;     ///< factor of the neighbours, 0 ... 8
   bool fill_holes = false;    ///< pixels that are not valid show what stands beside them

   static constexpr int kMostNeighbours = 35;
   static constexpr int kLargestMargin = 63;
   static constexpr int kLargestConfidence = 255;

   constexpr bool has_support_filter() const { return support_threshold > 0; }
   constexpr bool has_confidence() const { return confidence; }
   /// Any of its stages.
   constexpr bool has_post_processing() const { return has_support_filter() || fill_holes; }
   /// Of a pixel that is valid: neighbours, itself one of them, and the margin.
   constexpr int confidence_of(int neighbours, int margin) const {
      const int sum = margin_weight * margin + support_weight * neighbours;
      return sum < kLargestConfidence ? sum : kLargestConfidence;
   }

   template <class Self, class Visitor>
   static constexpr void options(Self& self, Visitor& visit) {
      visit("support_threshold", self.support_threshold, 0, kMostNeighbours, "the support threshold");
      visit("confidence", self.confidence);
      visit("margin_shift", self.margin_shift, 0, 16, "the margin's shift");
      visit("margin_weight", self.margin_weight, 0, 8, "the margin's weight");
      visit("support_weight", self.support_weight, 0, 8, "the support's weight");
      visit("fill_holes", self.fill_holes);
   }
   template <class Self>
   static constexpr Sentence missing(const Self& self) {
      if (self.confidence && !self.has_support_filter()) return "confidence needs a support threshold of 1 or more";
      return {};
   }
};

}  // namespace stereo
