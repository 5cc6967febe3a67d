// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "block_matching/matching.hpp"
#include "phase_correlation/matching.hpp"

namespace stereo::dynamic_range {

/// The codes of which two pixels are compared: their cost is the number of bits in which these differ.
enum class Codes : uint8_t { phase, census };

struct ComparedCodes {
   Codes codes = Codes::phase;

   template <class Self, class Visitor>
   static constexpr void options(Self& self, Visitor& visit) {
      visit("codes", self.codes);
   }
};

/// The search windows within the whole range, DisparityCount.
struct WindowRange {
   int window_disparities = 16;  ///< D, of each of the two search windows, 16 ... 64, a multiple of 8, at most T - 8

   template <class Self, class Visitor>
   static constexpr void options(Self& self, Visitor& visit) {
      visit("window_disparities", self.window_disparities, 16, 64, "the number of disparities of a search window");
   }
};

using phase_correlation::PhaseScales;

/// What matching in a search window that follows the scene computes: docs/algorithm.md defines each option. The
/// disparity range is the total one, T, a multiple of 4; the matching window has an odd side. The reference is the
/// right image. Models take it with images of any size from 8 rows on.
struct Matching : OptionGroups<Default<DisparityCount{128}>, WindowRange, Default<MatchingWindow{9}>, PixelFormat,
                               ComparedCodes, PhaseScales, CensusWindow, SubpixelSteps, MedianFilter, PostProcessing> {
   using OptionGroups::OptionGroups;

   static constexpr int kLeastDisparities = 32;
   static constexpr int kLeastWindow = 3, kLargestWindow = 31;

   /// Without one every pixel is valid.
   constexpr bool has_check() const { return has_support_filter(); }

   /// Pixels of the images to one of those in which the whole range is searched, along each axis.
   static constexpr int kCoarse = 4;
   /// Side of the blocks for which it is known where surfaces are.
   static constexpr int kBlock = 8;
   /// Side of the matching window in the coarse images.
   static constexpr int kCoarseWindow = 7;
   /// Disparities by which a search window reaches beyond the surfaces that it follows.
   static constexpr int kMargin = 6;
   /// Disparities by which the first disparity of a window may rise and fall from a column to the next one.
   static constexpr int kRise = 3, kFall = 1;

   constexpr int coarse_disparities() const { return disparities / kCoarse; }
   /// The largest first disparity of a search window.
   constexpr int last_base() const { return disparities - window_disparities; }

   /// The search of the whole range in the coarse images: phase codes ...
   constexpr phase_correlation::Matching coarse_phase() const {
      return {DisparityCount{coarse_disparities()}, MatchingWindow{kCoarseWindow}, PixelFormat(*this), PhaseScales{1},
              LeftRightThreshold{1}};
   }
   /// ... or census transforms.
   constexpr block_matching::Matching coarse_census() const {
      return {DisparityCount{coarse_disparities()},
              MatchingWindow{kCoarseWindow},
              PixelFormat(*this),
              Comparison{Cost::census},
              CensusWindow(*this),
              LeftRightThreshold{1}};
   }

   /// Why nothing can be matched with these options; empty when it can.
   constexpr Sentence problem() const {
      if (const Sentence sentence = problem_of(*this); !sentence.empty()) return sentence;
      if (disparities % kCoarse != 0) return "the disparity range must be a multiple of 4";
      if (window_disparities % kBlock != 0)
         return "the number of disparities of a search window must be a multiple of 8";
      if (window_disparities + kBlock > disparities)
         return "the disparity range must exceed a search window by 8 disparities or more";
      if (window_px % 2 == 0) return "the window side must be odd";
      if (const Sentence phase = coarse_phase().problem(); !phase.empty()) return phase;
      return coarse_census().problem();
   }
};

}  // namespace stereo::dynamic_range

namespace stereo {

template <>
struct Words<dynamic_range::Codes> {
   static constexpr const char* kName = "Codes";
   static constexpr const char* kWords[] = {"phase", "census"};
};

}  // namespace stereo
