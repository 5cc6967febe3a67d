// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "semi_global/config.hpp"
#include "trellis/matching.hpp"

namespace stereo::trellis {

using semi_global::kWindowConfig;
using semi_global::Structure;

/// What the post-processing is a template over.
struct MapConfig : semi_global::Config {
   static constexpr const char* kHolesBlock = "holes";  ///< the core's own block `fill` has the other name

   static constexpr bool has_runner_up() { return false; }
};

/// One hardware configuration of the trellis core. The named ones are in configurations.hpp.
struct Config : Image, Matching, Structure {
   /// The core of semi-global matching whose costs come in. It has the path from the right only: its rows go out as the
   /// trellis is traced back, from their last column to their first.
   constexpr semi_global::Config costs() const {
      semi_global::Matching matching = path_costs();
      matching.path_left = matching.path_above = false;
      Structure structure = *this;
      structure.run_time_settings = false;  // semi-global matching's are others
      return {Image(*this), matching, structure};
   }

   constexpr MapConfig map() const {
      MapConfig config{costs()};
      config.confidence = confidence;
      config.run_time_settings = run_time_settings;
      return config;
   }

   constexpr int output_width_px() const { return costs().output_width_px(); }
   constexpr int disparity_bits() const { return map().disparity_bits(); }
   constexpr int steps_per_pixel() const { return 1; }

   constexpr bool has_far_drop() const { return far_drop < disparities; }

   /// Drops from one state to another, the way that has most of them.
   constexpr int most_drops() const {
      int most = 0;
      for (int fall = 1; fall < disparities; ++fall) {
         const int drops = has_far_drop() ? fall / far_drop + fall % far_drop : fall;
         most = drops > most ? drops : most;
      }
      return most;
   }
   /// Largest difference of two states' path costs E in one column; docs/algorithm.md proves it.
   constexpr int largest_spread() const {
      const int highest = costs().largest_cost(), levels = disparities - 1;
      const int drops = most_drops();
      const int columns = 2 * drops > levels ? 2 * drops : levels;
      return columns * (occlusion_cost > highest ? occlusion_cost : highest) + drops * drop_cost;
   }
   /// Path costs are kept modulo 2^bits: less than half of it lies between any two that are compared.
   constexpr int path_bits() const {
      const int highest = costs().largest_cost(), step = occlusion_cost > highest ? occlusion_cost : highest;
      return 1 + bits_for(largest_spread() + drop_cost + highest + step);
   }

   /// Clocks that are enough from the last group that a column's costs depend on to the forward pass.
   constexpr int clocks_to_forward() const { return costs().clocks_to_last_check(); }

   template <class Self, class Visitor>
   static constexpr void options(Self& self, Visitor& visit) {
      Image::options(self, visit);
      Matching::options(self, visit);
      Structure::options(self, visit);
   }

   /// Why this core cannot be built; empty when it can. Each block relies on it instead of repeating it.
   constexpr Sentence problem() const {
      if (const Sentence sentence = Matching::problem(); !sentence.empty()) return sentence;
      if (const Sentence sentence = costs().problem(); !sentence.empty()) return sentence;
      if (costs().is_folded()) return "the trellis takes a pixel pair a clock";
      const int traced = has_support_filter() ? 2 * width_px : 0;
      if (run_time_settings &&
          costs().windows().groups_to_first_window() + clocks_to_forward() + traced + support_lag(*this) >=
              row_groups() * width_px)
         return "with run-time settings the image must be higher, for a frame's first column to be there before the "
                "next one";
      return {};
   }
};

template <const auto& C>
inline constexpr auto kCostConfig = C.costs();
template <const auto& C>
inline constexpr MapConfig kMapConfig = C.map();

template <const auto& C>
using PathCost = semi_global::PathCost<kCostConfig<C>>;
/// A path cost modulo 2^path_bits().
template <const auto& C>
using PathValue = uint_of_bits<C.path_bits()>;

}  // namespace stereo::trellis
