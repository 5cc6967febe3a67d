// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "block_matching/config.hpp"
#include "postprocessing/limits.hpp"
#include "semi_global/matching.hpp"
#include "support/hls_support.hpp"
#include "support/image.hpp"

namespace stereo::semi_global {

/// The block matching whose window costs the paths see: what the blocks up to the windows are templates over. Its map
/// has all cost columns: a path that leaves out a column would lose it for nothing. With full_width it is the same.
struct WindowConfig : block_matching::Config {
   constexpr int first_map_column() const {
      return full_width ? block_matching::Config::first_map_column() : first_cost_column();
   }
   constexpr int output_width_px() const {
      return full_width ? block_matching::Config::output_width_px() : cost_columns();
   }
   constexpr int output_first_column() const { return first_map_column() - reference_delay(); }

   /// Windows of a single pixel need no block that sums, so that block matching's limit does not hold.
   constexpr Sentence problem() const {
      block_matching::Config checked = *this;
      checked.run_time_settings = false;  // block matching's are others
      checked.front_clocks = 1;           // the phases that leave the time for more are the paths' alone
      if (window_px == 1 && aggregation == Aggregation::recursive) return "a single pixel has no recursive sum";
      if (window_px == 1) checked.window_px = 2;
      return checked.problem();
   }
};

/// How the core is built: the options are those of its window costs and of its winner tree.
using Structure = block_matching::Structure;

/// One hardware configuration of the semi-global core. Every block is a template over one; the named ones are in
/// configurations.hpp.
struct Config : Image, Matching, Structure {
   /// The phases of a pixel are the paths' alone.
   constexpr WindowConfig windows() const {
      WindowConfig config{{Image(*this), window_costs(), Structure(*this)}};
      config.clocks_per_pixel = 1;
      return config;
   }

   constexpr int output_width_px() const { return windows().output_width_px(); }
   constexpr int disparity_bits() const { return (subpixel || fill_holes ? 16 : 8) + (confidence ? 8 : 0); }
   constexpr int steps_per_pixel() const { return subpixel ? 16 : 1; }

   /// Levels of a tree over all disparities.
   constexpr int tree_levels() const {
      int levels = 0;
      while (1 << levels < disparities) ++levels;
      return levels;
   }

   // Numbers of the paths; docs/algorithm.md proves the bounds.
   /// Largest cost that a path sees.
   constexpr int largest_cost() const {
      const int shifted = windows().largest_window_cost() >> cost_shift;
      return shifted < cost_cap ? shifted : cost_cap;
   }
   constexpr int cost_bits() const { return bits_for(largest_cost()); }
   /// A core of one clock a pixel pair keeps K and A with the relief of the next column added, the same for all
   /// disparities. With several the next column is not known when they are.
   constexpr bool adds_next_relief() const { return has_relief() && !is_folded(); }
   /// The K and A of the row paths are kept with a bias of half their range: then their highest bit says that they are
   /// not below 0.
   constexpr int row_path_bits() const {
      const int highest = 2 * largest_cost() + p1 + (adds_next_relief() ? largest_relief() : 0);
      const int lowest = p2 + (largest_cost() > p1 ? largest_cost() - p1 : 0);
      int bits = 2;
      while (1 << (bits - 1) <= highest || 1 << (bits - 1) < lowest) ++bits;
      return bits;
   }
   constexpr int relief_bits() const { return bits_for(largest_relief()); }
   /// Only the left/right check compares sums of two columns, and needs the relief taken off again.
   constexpr bool takes_relief_off() const { return adds_next_relief() && has_left_right_check(); }
   /// Largest number that a row path adds to the sum, without the bias.
   constexpr int largest_row_path() const {
      return largest_cost() + (adds_next_relief() && !takes_relief_off() ? largest_relief() : 0);
   }
   constexpr int row_path_bias() const { return 1 << (row_path_bits() - 1); }
   /// The smallest P1 that ports may bring: that with which the row paths need no more bits, with P2 as it is. The
   /// largest penalties are the configuration's.
   constexpr int least_p1() const {
      const int least = largest_cost() + p2 - row_path_bias();
      return (path_left || path_right) && least > 0 ? least : 0;
   }
   /// Largest K of the path from above, which is never below 0.
   constexpr int largest_path_above() const { return p2_above() + largest_cost(); }
   /// Largest sum of the paths that a row is scanned for from its left end on, biases included.
   constexpr int largest_forward_sum() const {
      return (path_left ? row_path_bias() + largest_row_path() : 0) + (path_above ? largest_path_above() : 0);
   }
   constexpr int largest_sum() const {
      return largest_forward_sum() + (path_right ? row_path_bias() + largest_row_path() : 0);
   }
   /// Largest distance that ports can bring: no two sums differ by more.
   constexpr int largest_uniqueness() const {
      const int reached = largest_sum() < kLargestUniqueness ? largest_sum() : kLargestUniqueness;
      return reached < uniqueness_distance ? uniqueness_distance : reached;
   }
   /// Moves behind the last column of a row before its last word is in the memory that turns the row round.
   constexpr int turn_columns() const { return tree_levels() + 7; }

   // With several clocks a pixel its disparities come in as many phases (phases.hpp).
   constexpr bool is_folded() const { return clocks_per_pixel > 1; }
   constexpr int phase_disparities() const { return disparities / clocks_per_pixel; }

   /// As in Matching; ports may leave any disparity out.
   constexpr bool has_check() const { return Matching::has_check() || windows().has_lost_pixels(); }

   /// Clocks that are enough from the last group that a disparity depends on to the last check.
   constexpr int clocks_to_last_check() const { return 64 + disparities + (is_folded() ? 2 * clocks_per_pixel : 0); }
   /// Groups that are enough from the start of a frame to the last one that the check of its first disparity needs.
   constexpr int groups_to_last_check() const {
      const int turn = path_right ? width_px : 0, moves = tree_levels() + 10;
      return windows().groups_to_first_window() + turn + moves + (has_left_right_check() ? disparities - 1 : 0);
   }

   template <class Self, class Visitor>
   static constexpr void options(Self& self, Visitor& visit) {
      Image::options(self, visit);
      Matching::options(self, visit);
      Structure::options(self, visit);
   }

   /// Why this core cannot be built; empty when it can. Each block relies on it instead of repeating it.
   constexpr Sentence problem() const {
      if (sign_memory) return "a sign memory is for block matching";
      if (const Sentence sentence = Matching::problem(); !sentence.empty()) return sentence;
      if (const Sentence sentence = windows().problem(); !sentence.empty()) return sentence;
      if (const Sentence sentence = post_processing_problem(*this); !sentence.empty()) return sentence;
      if (pixels_per_clock != 1) return "the semi-global core takes one pixel pair a clock";
      if (const Sentence sentence = folding_problem(); !sentence.empty()) return sentence;
      if (disparities < 8) return "the disparity range must be 8 ... 256";
      const int turned = path_right && has_support_filter() ? width_px : 0;
      if (run_time_settings &&
          groups_to_last_check() + clocks_to_last_check() + turned + support_lag(*this) >= row_groups() * width_px)
         return "with run-time settings the image must be higher, for a frame's first disparity to leave before the "
                "next one";
      if (full_width && width_px < turn_columns() + 4) {
         Sentence sentence = "with a map of full width the image must be ";
         return sentence << turn_columns() + 4 << " columns wide or more";
      }
      if (!full_width && !is_folded() && width_px - output_width_px() < turn_columns()) {
         Sentence sentence = "the disparity range must leave ";
         return sentence << turn_columns() << " columns between the maps of two rows but leaves "
                         << width_px - output_width_px();
      }
      return {};
   }

  private:
   constexpr Sentence folding_problem() const {
      if (const Sentence sentence = front_problem(); !sentence.empty()) return sentence;
      if (!is_folded()) return {};
      if (disparities % clocks_per_pixel != 0) return "the clocks a pixel pair must divide the disparity range";
      if (clocks_per_pixel < 4) return "the loop of a semi-global path takes four clocks a pixel pair or more, or one";
      if (phase_disparities() < 2)
         return "with several clocks a pixel pair two disparities or more must be left for each";
      if (aggregation != Aggregation::direct)
         return "with several clocks a pixel pair semi-global costs have no recursive sums";
      if (run_time_size) return "with several clocks a pixel pair there is no run-time size";
      if (output_width_px() * clocks_per_pixel > 1 << 16)
         return "with so many clocks a pixel pair a row of the map must be shorter";
      return {};
   }
};

template <const auto& C>
inline constexpr auto kWindowConfig = C.windows();

/// What the blocks behind the sums are templates over: sums stand in for window costs.
struct SumConfig : WindowConfig {
   int largest_sum;
   int uniqueness_distance;

   constexpr int largest_window_cost() const { return largest_sum; }
   constexpr bool has_uniqueness_check() const { return uniqueness_distance > 0; }
};

/// With a path from the right, rows come out of it from their last column to their first: what is left and right
/// changes places for what looks along the row.
template <const auto& C>
inline constexpr SumConfig kSumConfig = [] {
   WindowConfig config = C.windows();
   if (C.path_right) config.reference = C.reference == Reference::right ? Reference::left : Reference::right;
   return SumConfig{config, C.largest_sum(), C.uniqueness_distance};
}();

/// Types of a cost, of K and A of a row path, of K of the path from above, and of sums.
template <const auto& C>
using PathCost = uint_of_bits<C.cost_bits()>;
template <const auto& C>
using Relief = uint_of_bits<C.relief_bits()>;
template <const auto& C>
using RowPathValue = uint_of_bits<C.row_path_bits()>;
template <const auto& C>
using AbovePathValue = uint_of_bits<bits_for(C.largest_path_above())>;
template <const auto& C>
using ForwardSum = uint_of_bits<bits_for(C.largest_forward_sum())>;

}  // namespace stereo::semi_global
