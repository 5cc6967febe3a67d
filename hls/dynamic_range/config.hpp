// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "block_matching/config.hpp"
#include "dynamic_range/matching.hpp"
#include "phase_correlation/config.hpp"
#include "postprocessing/limits.hpp"
#include "support/image.hpp"

namespace stereo::dynamic_range {

/// How the core is built. The slices are those of the coarse search.
struct Structure : OptionGroups<SliceSize, WinnerGroup> {
   using OptionGroups::OptionGroups;
};

/// What the post-processing is a template over: a map of the whole range.
struct MapConfig
    : Image,
      OptionGroups<DisparityCount, WindowRange, ReferenceImage, SubpixelSteps, MedianFilter, PostProcessing> {
   static constexpr bool has_runner_up() { return false; }
   constexpr int output_width_px() const { return width_px - window_disparities; }
   constexpr int disparity_bits() const { return (subpixel || fill_holes ? 16 : 8) + (confidence ? 8 : 0); }
   constexpr int steps_per_pixel() const { return subpixel ? 16 : 1; }
};

/// One hardware configuration of the core with a dynamic range. The named ones are in configurations.hpp.
struct Config : Image, Matching, Structure {
   /// Of the smallest image that the core takes: a coarse row needs 7 rows around it.
   static constexpr int kLeastPixels = 40 * 32;

   // The images in which the whole range is searched. Beside the last column stands as much more as the search needs.
   constexpr int coarse_columns() const { return width_px / kCoarse; }
   constexpr int coarse_rows() const { return height_px / kCoarse; }
   constexpr Image coarse_image() const {
      return {.width_px = coarse_columns() + coarse_disparities(), .height_px = coarse_rows()};
   }
   constexpr phase_correlation::Config coarse_phase_config() const {
      return {coarse_image(), coarse_phase(), shared_options<phase_correlation::Structure>(*this)};
   }
   constexpr block_matching::Config coarse_census_config() const {
      return {coarse_image(), coarse_census(), shared_options<block_matching::Structure>(*this)};
   }

   // What each search window does, as if it stood still: D disparities with recursive sums.
   constexpr phase_correlation::Config window_phase_config() const {
      return {Image(*this),
              {DisparityCount{window_disparities}, MatchingWindow(*this), PixelFormat(*this), PhaseScales(*this),
               SubpixelSteps(*this)},
              {Summation{Aggregation::recursive}, SliceSize{window_disparities}, WinnerGroup(*this)}};
   }
   constexpr block_matching::Config window_census_config() const {
      return {Image(*this),
              {DisparityCount{window_disparities}, MatchingWindow(*this), PixelFormat(*this), Comparison{Cost::census},
               CensusWindow(*this), SubpixelSteps(*this)},
              {Summation{Aggregation::recursive}, SliceSize{window_disparities}, WinnerGroup(*this)}};
   }

   // Blocks of pixels for which it is known where surfaces are.
   constexpr int block_columns() const { return width_px / kBlock; }
   constexpr int block_rows() const { return height_px / kBlock; }

   constexpr MapConfig map() const {
      MapConfig config{Image(*this), {}};
      config.share(*this);
      return config;
   }
   constexpr bool has_map_block() const { return median || has_post_processing(); }
   constexpr int output_width_px() const { return map().output_width_px(); }
   constexpr int disparity_bits() const { return map().disparity_bits(); }
   constexpr int steps_per_pixel() const { return map().steps_per_pixel(); }

   /// Groups by which the windows follow the newest codes: the searched pixels of the whole range must have come.
   constexpr int ahead_groups() const { return last_base() + kBank; }
   /// Of a memory's array in C++: beyond 100,000 bits the tool takes another kind of memory.
   static constexpr int kMostMemoryBits = 96000;
   /// Of the code of a pixel.
   constexpr int code_bytes() const {
      const int bits =
          codes == Codes::phase ? 6 * phase_scales : census_bits(census_width_px, census_height_px, census_pattern);
      return bits <= 8 ? 1 : bits <= 16 ? 2 : bits <= 32 ? 4 : 8;
   }
   /// Neighbouring searched pixels that can be read at once.
   static constexpr int kBank = 4;

   template <class Self, class Visitor>
   static constexpr void options(Self& self, Visitor& visit) {
      Image::options(self, visit);
      Matching::options(self, visit);
      Structure::options(self, visit);
   }

   /// Why this core cannot be built; empty when it can. Each block relies on it instead of repeating it.
   constexpr Sentence problem() const {
      if (const Sentence sentence = Image::problem(); !sentence.empty()) return sentence;
      if (const Sentence sentence = Matching::problem(); !sentence.empty()) return sentence;
      if (const Sentence limit = first_beyond_limits<Structure>(*this); !limit.empty()) return limit;
      if (pixels_per_clock != 1) return "the core with a dynamic range takes one pixel pair a clock";
      if (width_px % kBlock != 0 || height_px % kBlock != 0)
         return "the width and height of the images must be multiples of 8";
      if (coarse_rows() < kCoarseWindow) return "the images must have 32 rows or more";
      if (width_px <= disparities) return "the image width must exceed the disparity range";
      if (const Sentence sentence = post_processing_problem(map()); !sentence.empty()) return sentence;
      if ((window_px + 2) * width_px / kBank * 8 * code_bytes() > kMostMemoryBits)
         return "the rows of searched codes need larger memories than the tool takes: fewer columns or a smaller "
                "window";
      if (codes == Codes::phase) {
         if (const Sentence sentence = coarse_phase_config().problem(); !sentence.empty()) return sentence;
         return window_phase_config().problem();
      }
      if (const Sentence sentence = coarse_census_config().problem(); !sentence.empty()) return sentence;
      return window_census_config().problem();
   }
};

/// The configuration of the search in the coarse images, of one family or the other.
template <const Config& C>
inline constexpr auto kCoarseConfig = [] {
   if constexpr (C.codes == Codes::phase) return C.coarse_phase_config();
   else return C.coarse_census_config();
}();

template <const Config& C>
inline constexpr MapConfig kMapConfig = C.map();

/// What the blocks of a search window are templates over.
template <const Config& C>
inline constexpr auto kWindowConfig = [] {
   if constexpr (C.codes == Codes::phase) return C.window_phase_config().codes();
   else return C.window_census_config();
}();

}  // namespace stereo::dynamic_range
