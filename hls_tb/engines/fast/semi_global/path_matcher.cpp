// SPDX-License-Identifier: Apache-2.0
#include "engines/fast/semi_global/path_matcher.hpp"

#include <cstdlib>

#include "definition/block_matching/matching_input.hpp"
#include "engines/fast/row_winners.hpp"
#include "engines/fast/semi_global/path_costs.hpp"
#include "engines/fast/semi_global/paths.hpp"

namespace stereo::semi_global {
namespace {

/// Loops run over whole vectors of this many disparities.
constexpr int kVector = 32;

template <class PixelCost, class Sum, class Lane, int Fixed = 0>
class Matcher {
  public:
   STEREO_INTO_CLONES Matcher(const PixelRows& pixels, const Matching& matching, int lanes, DisparityMap& map)
       : matching_(matching),
         lanes_(lanes),
         map_(map),
         window_costs_(pixels, matching, lanes),
         costs_(std::size_t(map.width) * std::size_t(lanes)),
         sums_(costs_),
         smallest_(std::size_t(map.width)),
         beyond_(std::size_t(lanes)),
         total_(std::size_t(lanes)),
         from_left_(matching, lanes),
         from_right_(matching, lanes),
         from_above_(matching, matching.path_above ? map.width : 0, lanes),
         winners_(std::size_t(map.width)),
         other_(map.width + lanes) {
      std::fill(beyond_.begin() + matching.disparities, beyond_.end(), std::numeric_limits<Lane>::max());
   }

   STEREO_INTO_CLONES void match() {
      for (int y = 0; y < map_.height; ++y) {
         window_costs_.next_row(costs_.data(), smallest_.data());
         row_paths();
         winners(y);
      }
   }

  private:
   STEREO_INTO_CLONES const Lane* costs(int x) const { return costs_.data() + std::ptrdiff_t(x) * lanes_; }
   STEREO_INTO_CLONES Lane* sums(int x) { return sums_.data() + std::ptrdiff_t(x) * lanes_; }

   /// Both paths in one loop: neither waits for the other. Each column first gets what comes to it first.
   STEREO_INTO_CLONES void row_paths() {
      // K + bias less this is K of the path against its least number, so that the sum of the paths fits a lane.
      const Lane excess = Lane(RowPathState<Lane, Fixed>::kBias - Lane(PathBounds(matching_).lowest_path));
      const int last = map_.width - 1;
      std::fill(sums_.begin(), sums_.end(), Lane(0));
      from_left_.start_row();
      from_right_.start_row();
      for (int i = 0; i <= last; ++i) {
         if (matching_.path_left) from_left_.add_next(costs(i), smallest(i), beyond_.data(), excess, sums(i));
         const int x = last - i;
         if (matching_.path_right) from_right_.add_next(costs(x), smallest(x), beyond_.data(), excess, sums(x));
      }
   }
   STEREO_INTO_CLONES Lane smallest(int x) const { return smallest_[std::size_t(x)]; }

   STEREO_INTO_CLONES void winners(int y) {
      other_.restart();
      for (int x = 0; x < map_.width; ++x) {
         const int lanes = Fixed > 0 ? Fixed : lanes_;
         Lane* const __restrict to = total_.data();
         const Lane* const __restrict from = sums(x);
         const Lane* const __restrict beyond = beyond_.data();
         if (matching_.path_above) from_above_.add(x, costs(x), beyond, from, to);
         else
            for (int d = 0; d < lanes; ++d) to[d] = Lane(from[d] | beyond[d]);
         if (matching_.has_left_right_check()) fast::offer(other_, x, to, lanes, matching_.ties);
         match_pixel(x, y);
      }
      if (matching_.path_above) from_above_.next_row();
      if (matching_.has_left_right_check()) check_left_right(y);
   }

   STEREO_INTO_CLONES void match_pixel(int x, int y) {
      const Lane* const sums = total_.data();
      const int disparities = matching_.disparities;
      const fast::PixelResult<Lane> pixel = fast::find_winner(sums, Fixed > 0 ? Fixed : lanes_, matching_.ties);
      winners_[std::size_t(x)] = pixel.winner;
      map_.at(x, y) = matching_.subpixel ? fast::refined(sums, disparities, pixel) : uint16_t(pixel.winner);
      if (!matching_.has_uniqueness_check()) return;
      const uint64_t close = uint64_t(pixel.smallest) + uint64_t(matching_.uniqueness_distance) - 1;
      if (!fast::is_unique(sums, disparities, lanes_, pixel, close)) map_.valid_at(x, y) = 0;
   }

   STEREO_INTO_CLONES void check_left_right(int y) {
      for (int x = 0; x < map_.width; ++x) {
         const int winner = winners_[std::size_t(x)], back = int(other_.disparity[std::size_t(x + winner)]);
         if (std::abs(back - winner) > matching_.left_right_threshold) map_.valid_at(x, y) = 0;
      }
   }

   const Matching& matching_;
   int lanes_;
   DisparityMap& map_;
   WindowCosts<PixelCost, Sum, Fixed> window_costs_;
   std::vector<Lane> costs_, sums_;  ///< [x][d]: of one row
   std::vector<Lane> smallest_;      ///< [x]: of the costs
   std::vector<Lane> beyond_;        ///< [d]: all bits set behind the last disparity
   std::vector<Lane> total_;         ///< [d]: S
   RowPathState<Lane, Fixed> from_left_, from_right_;
   PathFromAbove<Lane, Fixed> from_above_;
   std::vector<int> winners_;  ///< [x]: of this row
   fast::OtherWinners<Lane> other_;
};

/// Sizes that many cores have: the compiler unrolls loops over a fixed number of lanes.
STEREO_VECTOR_CLONES void match_8_8_64(const PixelRows& pixels, const Matching& matching, DisparityMap& map) {
   Matcher<uint8_t, uint8_t, uint8_t, 64>(pixels, matching, 64, map).match();
}
STEREO_VECTOR_CLONES void match_8_8_128(const PixelRows& pixels, const Matching& matching, DisparityMap& map) {
   Matcher<uint8_t, uint8_t, uint8_t, 128>(pixels, matching, 128, map).match();
}
// Window costs of 8, 16 and 32 bits, and paths of 8 and 16.
STEREO_VECTOR_CLONES void match_8_8(const PixelRows& pixels, const Matching& matching, int lanes, DisparityMap& map) {
   Matcher<uint8_t, uint8_t, uint8_t>(pixels, matching, lanes, map).match();
}
STEREO_VECTOR_CLONES void match_16_8(const PixelRows& pixels, const Matching& matching, int lanes, DisparityMap& map) {
   Matcher<uint8_t, uint16_t, uint8_t>(pixels, matching, lanes, map).match();
}
STEREO_VECTOR_CLONES void match_16_16(const PixelRows& pixels, const Matching& matching, int lanes, DisparityMap& map) {
   Matcher<uint8_t, uint16_t, uint16_t>(pixels, matching, lanes, map).match();
}
STEREO_VECTOR_CLONES void match_32_16(const PixelRows& pixels, const Matching& matching, int lanes, DisparityMap& map) {
   Matcher<uint8_t, uint32_t, uint16_t>(pixels, matching, lanes, map).match();
}
STEREO_VECTOR_CLONES void match_ssd(const PixelRows& pixels, const Matching& matching, int lanes, DisparityMap& map) {
   Matcher<uint16_t, uint32_t, uint16_t>(pixels, matching, lanes, map).match();
}

}  // namespace

DisparityMap match_paths(const GrayImage& left, const GrayImage& right, const Matching& matching) {
   const int lanes = (matching.disparities + kVector - 1) / kVector * kVector;
   const PixelRows pixels(left, right, matching, kVector);
   DisparityMap map(map_width(left.width, matching), left.height, 0, matching.subpixel);
   const int64_t side_x = std::min(matching.window_px, pixels.columns),
                 side_y = std::min(matching.window_px, map.height);
   const int64_t window_cost = side_x * side_y * block_matching::largest_pixel_cost(matching.window_costs());
   const bool narrow_paths = PathBounds(matching).fit(8);
   if (matching.cost == Cost::ssd) match_ssd(pixels, matching, lanes, map);
   else if (window_cost < 1 << 8 && narrow_paths && lanes == 64) match_8_8_64(pixels, matching, map);
   else if (window_cost < 1 << 8 && narrow_paths && lanes == 128) match_8_8_128(pixels, matching, map);
   else if (window_cost < 1 << 8 && narrow_paths) match_8_8(pixels, matching, lanes, map);
   else if (window_cost < 1 << 16 && narrow_paths) match_16_8(pixels, matching, lanes, map);
   else if (window_cost < 1 << 16) match_16_16(pixels, matching, lanes, map);
   else match_32_16(pixels, matching, lanes, map);
   return map;
}

}  // namespace stereo::semi_global
