// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "block_matching/config.hpp"
#include "dynamic_range/matching.hpp"
#include "phase_correlation/config.hpp"
#include "support/image.hpp"

namespace stereo::dynamic_range {

/// How the core is built. None of it changes a result.
struct Structure {
   int slice_disparities = 25;  ///< of the coarse search: disparities between two registers of its chain, at least 2
   int winner_group = 2;        ///< candidates that one clock of a winner-take-all tree compares: 2 ... 16

   template <class Self, class Visitor>
   static constexpr void options(Self& self, Visitor& visit) {
      visit("slice_disparities", self.slice_disparities, 2, kUnlimited, "the number of disparities of a slice");
      visit("winner_group", self.winner_group, 2, 16, "the number of candidates of a winner group");
   }
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
      phase_correlation::Structure structure;
      structure.slice_disparities = slice_disparities;
      structure.winner_group = winner_group;
      return {coarse_image(), coarse_phase(), structure};
   }
   constexpr block_matching::Config coarse_census_config() const {
      block_matching::Structure structure;
      structure.slice_disparities = slice_disparities;
      structure.winner_group = winner_group;
      return {coarse_image(), coarse_census(), structure};
   }

   // What each search window does, as if it stood still: D disparities with recursive sums.
   constexpr phase_correlation::Config window_phase_config() const {
      phase_correlation::Matching matching{.disparities = window_disparities, .window_px = window_px};
      matching.pixel_bits = pixel_bits;
      matching.phase_scales = phase_scales;
      matching.subpixel = subpixel;
      phase_correlation::Structure structure;
      structure.aggregation = Aggregation::recursive;
      structure.slice_disparities = window_disparities;
      structure.winner_group = winner_group;
      return {Image(*this), matching, structure};
   }
   constexpr block_matching::Config window_census_config() const {
      block_matching::Matching matching{.disparities = window_disparities, .window_px = window_px};
      matching.pixel_bits = pixel_bits;
      matching.cost = Cost::census;
      matching.census_width_px = census_width_px;
      matching.census_height_px = census_height_px;
      matching.subpixel = subpixel;
      block_matching::Structure structure;
      structure.aggregation = Aggregation::recursive;
      structure.slice_disparities = window_disparities;
      structure.winner_group = winner_group;
      return {Image(*this), matching, structure};
   }

   // Blocks of pixels for which it is known where surfaces are.
   constexpr int block_columns() const { return width_px / kBlock; }
   constexpr int block_rows() const { return height_px / kBlock; }

   constexpr int output_width_px() const { return width_px - window_disparities; }
   constexpr int disparity_bits() const { return subpixel ? 16 : 8; }
   constexpr int steps_per_pixel() const { return subpixel ? 16 : 1; }

   /// Groups by which the windows follow the newest codes: the searched pixels of the whole range must have come.
   constexpr int ahead_groups() const { return last_base() + kBank; }
   /// Of a memory's array in C++: beyond 100,000 bits the tool takes another kind of memory.
   static constexpr int kMostMemoryBits = 96000;
   /// Of the code of a pixel.
   constexpr int code_bytes() const {
      const int bits = codes == Codes::phase ? 6 * phase_scales : census_width_px * census_height_px - 1;
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

/// What the blocks of a search window are templates over.
template <const Config& C>
inline constexpr auto kWindowConfig = [] {
   if constexpr (C.codes == Codes::phase) return C.window_phase_config().codes();
   else return C.window_census_config();
}();

}  // namespace stereo::dynamic_range
