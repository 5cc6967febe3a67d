// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "support/image.hpp"
#include "support/matching_options.hpp"

namespace stereo::absolute_difference {

/// What the family computes: |left - right| of the pixels at the same place.
struct Matching {
   int least_difference = 0;  ///< of a valid pixel, 0 ... 255

   template <class Self, class Visitor>
   static constexpr void options(Self& self, Visitor& visit) {
      visit("least_difference", self.least_difference, 0, 255, "the least difference");
   }
   constexpr Sentence problem() const { return first_beyond_limits(*this); }
};

struct Structure {
   int delay_groups = 0;  ///< by which the core holds its results back, 0 or 3 ... 256

   template <class Self, class Visitor>
   static constexpr void options(Self& self, Visitor& visit) {
      visit("delay_groups", self.delay_groups, 0, 256, "the number of groups of the delay");
   }
};

struct Config : Image, Matching, Structure {
   constexpr int output_width_px() const { return width_px; }
   constexpr int disparity_bits() const { return 8; }
   constexpr int steps_per_pixel() const { return 1; }

   template <class Self, class Visitor>
   static constexpr void options(Self& self, Visitor& visit) {
      Image::options(self, visit);
      Matching::options(self, visit);
      Structure::options(self, visit);
   }
   constexpr Sentence problem() const {
      if (const Sentence sentence = Image::problem(); !sentence.empty()) return sentence;
      if (const Sentence sentence = Matching::problem(); !sentence.empty()) return sentence;
      return first_beyond_limits<Structure>(*this);
   }
};

}  // namespace stereo::absolute_difference
