// SPDX-License-Identifier: Apache-2.0
// The options of how a core is built that several families have. None of them changes a result.
#pragma once

#include "support/matching_options.hpp"
#include "support/option_groups.hpp"

namespace stereo {

struct Summation {
   Aggregation aggregation = Aggregation::direct;

   template <class Self, class Visitor>
   static constexpr void options(Self& self, Visitor& visit) {
      visit("aggregation", self.aggregation);
   }
};

struct SliceSize {
   int slice_disparities = 25;  ///< disparities between two registers of the chain that carries the pixels, at least 2

   template <class Self, class Visitor>
   static constexpr void options(Self& self, Visitor& visit) {
      visit("slice_disparities", self.slice_disparities, 2, kUnlimited, "the number of disparities of a slice");
   }
};

struct WinnerGroup {
   int winner_group = 2;  ///< candidates that one clock of the winner-take-all tree compares: 2 ... 16

   template <class Self, class Visitor>
   static constexpr void options(Self& self, Visitor& visit) {
      visit("winner_group", self.winner_group, 2, 16, "the number of candidates of a winner group");
   }
};

/// Logic for clocks: fewer disparities at once.
struct Folding {
   int clocks_per_pixel =
       1;                 ///< F clocks at least from one pixel pair to the next, for which D/F disparities are built
   int front_clocks = 1;  ///< of what is compared in front of the disparities: 2 where F leaves the time for it

   template <class Self, class Visitor>
   static constexpr void options(Self& self, Visitor& visit) {
      visit("clocks_per_pixel", self.clocks_per_pixel, 1, 128, "the number of clocks a pixel pair");
      visit("front_clocks", self.front_clocks, 1, 2, "the number of clocks of the comparisons in front");
   }

   constexpr Sentence front_problem() const {
      if (front_clocks > 1 && clocks_per_pixel < 3)
         return "with two clocks of the comparisons in front a pixel pair must take three clocks or more";
      return {};
   }
};

/// Of a configuration of any family.
template <const auto& C>
inline constexpr int kFrontClocks = [] {
   if constexpr (requires { C.front_clocks; }) return C.front_clocks;
   else return 1;
}();

/// What comes from ports.
struct RunTime {
   bool run_time_settings = false;  ///< the family's settings, taken over with each start of frame
   bool run_time_size = false;      ///< image width and height, up to the configuration's, taken over at a reset

   template <class Self, class Visitor>
   static constexpr void options(Self& self, Visitor& visit) {
      visit("run_time_settings", self.run_time_settings);
      visit("run_time_size", self.run_time_size);
   }
};

}  // namespace stereo
