// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "support/matching_options.hpp"
#include "support/options.hpp"

namespace stereo::block_matching {

inline constexpr int kFarthest = 1 << 24;  ///< px: beyond any image, and far from where sums of columns would overflow
inline constexpr const char* kPartNeedsFullWidth = "first_disparity and last_disparity need a map of full width";

/// What block matching computes: docs/algorithm.md defines each option. Models take it with images of any size.
struct Matching {
   int disparities = 64;   ///< disparity range D: 0 <= d < D, 1 ... 256 and below the image width
   int window_px = 3;      ///< side B of the square matching window, 1 or more, odd or even
   int min_disparity = 0;  ///< m: disparity d stands for m + d pixels
   int pixel_bits = 8;     ///< grey values are 0 ... 2^pixel_bits - 1; 8, 10 or 12
   Reference reference = Reference::right;
   Cost cost = Cost::sad;
   int census_width_px = 5;   ///< 3 ... 9, odd
   int census_height_px = 5;  ///< 3 ... 7, odd
   Prefilter prefilter = Prefilter::none;
   int prefilter_cap = 31;  ///< 1 ... 63 * 2^(pixel_bits - 8); filtered pixels are 0 ... 2*cap
   Ties ties = Ties::smallest;
   int left_right_threshold = -1;  ///< largest difference of a consistent pair of disparities, below D; -1: no check
   int uniqueness_percent = 0;     ///< 0 ... 100; 0: no check
   int texture_threshold = 0;      ///< 0 ... prefilter_cap * window_px^2; 0: no check
   bool subpixel = false;          ///< disparities in sixteenths of a pixel
   bool median = false;            ///< median of 3x3 disparities
   bool full_width = false;        ///< a disparity for every pixel whose window lies in the image
   int first_disparity = 0;        ///< with full_width: lowest of the disparities 0 ... D-1 that is searched
   int last_disparity = -1;        ///< and the highest one; -1: D-1

   constexpr bool has_left_right_check() const { return left_right_threshold >= 0; }
   constexpr bool has_uniqueness_check() const { return uniqueness_percent > 0; }
   constexpr bool has_texture_check() const { return texture_threshold > 0; }
   /// Any of them: without one every pixel is valid.
   constexpr bool has_check() const {
      return has_left_right_check() || has_uniqueness_check() || has_texture_check() || has_lost_pixels();
   }
   /// With full_width: some pixels at an end of a row have no candidate in the other image.
   constexpr bool has_lost_pixels() const {
      return full_width && (min_disparity + first_disparity > 0 || min_disparity + last_searched() < 0 ||
                            first_disparity > last_searched());
   }
   constexpr int last_searched() const { return last_disparity < 0 ? disparities - 1 : last_disparity; }
   /// Whether an option says which part is searched, be it all of it.
   constexpr bool names_a_part() const { return first_disparity != 0 || last_disparity != -1; }
   constexpr bool searches_all() const { return first_disparity == 0 && last_searched() == disparities - 1; }

   template <class Self, class Visitor>
   static constexpr void options(Self& self, Visitor& visit) {
      visit("disparities", self.disparities, 1, 256, "the disparity range");
      visit("window_px", self.window_px, 1, kUnlimited, "the window side");
      visit("min_disparity", self.min_disparity, -kFarthest, kFarthest, "the smallest disparity");
      visit("pixel_bits", self.pixel_bits, 8, 12, "the number of bits of a pixel");
      visit("reference", self.reference);
      visit("cost", self.cost);
      visit("census_width_px", self.census_width_px, 3, 9, "the census window's width");
      visit("census_height_px", self.census_height_px, 3, 7, "the census window's height");
      visit("prefilter", self.prefilter);
      visit("prefilter_cap", self.prefilter_cap, 1, self.largest_cap(), "the prefilter's cap");
      visit("ties", self.ties);
      visit("left_right_threshold", self.left_right_threshold, -1, self.disparities - 1, "the left/right threshold");
      visit("uniqueness_percent", self.uniqueness_percent, 0, 100, "the uniqueness in percent");
      visit("texture_threshold", self.texture_threshold, 0, self.largest_texture(), "the texture threshold");
      visit("subpixel", self.subpixel);
      visit("median", self.median);
      visit("full_width", self.full_width);
      const int highest = self.full_width ? self.disparities - 1 : 0;
      visit("first_disparity", self.first_disparity, 0, highest, "the first disparity");
      visit("last_disparity", self.last_disparity, -1, self.full_width ? highest : -1, "the last disparity");
   }

   /// Why nothing can be matched with these options; empty when it can.
   constexpr Sentence problem() const {
      if (!full_width && names_a_part()) return kPartNeedsFullWidth;
      if (const Sentence limit = first_beyond_limits(*this); !limit.empty()) return limit;
      if (pixel_bits % 2 != 0) {
         Sentence sentence = "the number of bits of a pixel is ";
         return sentence << pixel_bits << " but must be 8, 10 or 12";
      }
      if (census_width_px % 2 == 0 || census_height_px % 2 == 0) {
         Sentence sentence = "the census window is ";
         return sentence << census_width_px << "x" << census_height_px << " but both sides must be odd";
      }
      if (cost == Cost::census && prefilter != Prefilter::none) return "the census transform takes no prefilter";
      if (has_texture_check() && prefilter != Prefilter::xsobel) return "the texture check needs the prefilter";
      if (full_width && window_px < 2) return "a map of full width needs a window of 2x2 pixels or more";
      return {};
   }

   constexpr int largest_pixel() const { return (1 << pixel_bits) - 1; }
   /// Of the prefilter: the same share of the range of grey values for each width.
   constexpr int largest_cap() const { return pixel_bits < 8 || pixel_bits > 12 ? kUnlimited : 63 << (pixel_bits - 8); }

  private:
   /// Of a window; without the prefilter there is no check whose threshold could be too high.
   constexpr int largest_texture() const {
      if (prefilter == Prefilter::none || prefilter_cap < 1 || window_px < 1 ||
          window_px > kUnlimited / prefilter_cap / window_px)
         return kUnlimited;
      return prefilter_cap * window_px * window_px;
   }
};

}  // namespace stereo::block_matching
