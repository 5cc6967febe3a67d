// SPDX-License-Identifier: Apache-2.0
#include "engines/fast/semi_global/path_matcher.hpp"

#include <cmath>
#include <cstdlib>

#include "definition/block_matching/matching_input.hpp"
#include "engines/fast/bands.hpp"
#include "engines/fast/row_winners.hpp"
#include "engines/fast/semi_global/path_costs.hpp"
#include "engines/fast/semi_global/paths.hpp"
#include "engines/fast/semi_global/row_bands.hpp"

namespace stereo::semi_global {
namespace {

/// Loops run over whole vectors of this many disparities.
constexpr int kVector = 32;

/// What the threads share.
template <class Pixel, class Lane, int Fixed>
struct Shared {
   const PixelRows<Pixel>& pixels;
   const Matching& matching;
   const DeepImage& relief;  ///< of the map, where P2 falls
   int lanes;
   DisparityMap& map;
   RowBands bands;
   PathFromAbove<Lane, Fixed> from_above;
};

/// The work of one thread: the costs and the paths along the rows of its bands, whatever stands above them, then the
/// path from above and the winners behind the thread of the band above.
template <class Pixel, class PixelCost, class Sum, class Lane, int Fixed>
class Matcher {
  public:
   STEREO_INTO_CLONES explicit Matcher(Shared<Pixel, Lane, Fixed>& shared)
       : shared_(shared),
         matching_(shared.matching),
         lanes_(shared.lanes),
         map_(shared.map),
         window_costs_(shared.pixels, shared.matching, lanes_),
         beyond_(std::size_t(lanes_)),
         total_(std::size_t(lanes_)),
         from_left_(shared.matching, lanes_),
         from_right_(shared.matching, lanes_),
         rows_(std::size_t(shared.bands.rows_of_band()), Row(map_.width, lanes_)) {
      std::fill(beyond_.begin() + matching_.disparities, beyond_.end(), std::numeric_limits<Lane>::max());
   }

   STEREO_INTO_CLONES void match() {
      for (int band = shared_.bands.take(); band < shared_.bands.count(); band = shared_.bands.take()) {
         const int first = shared_.bands.first_row(band), end = shared_.bands.end_row(band);
         window_costs_.go_to(first);
         for (int y = first; y < end; ++y) begin_row(rows_[std::size_t(y - first)], y);
         for (int block = 0; block < shared_.bands.blocks(); ++block) {
            const int first_column = shared_.bands.first_column(block), end_column = shared_.bands.end_column(block);
            shared_.bands.enter(block, band);
            for (int y = first; y < end; ++y) winners(rows_[std::size_t(y - first)], y, first_column, end_column);
            shared_.bands.leave(block, band);
         }
         if (matching_.has_left_right_check())
            for (int y = first; y < end; ++y) check_left_right(rows_[std::size_t(y - first)], y);
      }
   }

  private:
   struct Row {
      Row(int width, int lanes)
          : costs(std::size_t(width) * std::size_t(lanes)),
            sums(costs),
            smallest(std::size_t(width)),
            winners(std::size_t(width)),
            other(width + lanes) {}

      std::vector<Lane> costs, sums;  ///< [x][d]
      std::vector<Lane> smallest;     ///< [x]: of the costs
      std::vector<int> winners;       ///< [x]
      fast::OtherWinners<Lane> other;
   };

   STEREO_INTO_CLONES void begin_row(Row& row, int y) {
      window_costs_.next_row(row.costs.data(), row.smallest.data());
      row_paths(row, matching_.largest_relief() > 0 ? shared_.relief.row(y) : nullptr);
      row.other.restart();
   }

   STEREO_INTO_CLONES const Lane* costs(const Row& row, int x) const {
      return row.costs.data() + std::ptrdiff_t(x) * lanes_;
   }
   STEREO_INTO_CLONES Lane* sums(Row& row, int x) const { return row.sums.data() + std::ptrdiff_t(x) * lanes_; }

   /// Both paths in one loop: neither waits for the other. Each column first gets what comes to it first.
   STEREO_INTO_CLONES void row_paths(Row& row, const uint16_t* relief) {
      // K + bias less this is K of the path against its least number, so that the sum of the paths fits a lane.
      const Lane excess = Lane(RowPathState<Lane, Fixed>::kBias - Lane(PathBounds(matching_).lowest_path));
      const int last = map_.width - 1;
      std::fill(row.sums.begin(), row.sums.end(), Lane(0));
      from_left_.start_row();
      from_right_.start_row();
      for (int i = 0; i <= last; ++i) {
         const bool falls = relief != nullptr && i > 0;
         if (matching_.path_left) add_next(from_left_, row, i, falls ? relief[i] : 0, excess);
         if (matching_.path_right) add_next(from_right_, row, last - i, falls ? relief[last - i + 1] : 0, excess);
      }
   }
   STEREO_INTO_CLONES void add_next(RowPathState<Lane, Fixed>& path, Row& row, int x, int relief, Lane excess) {
      path.add_next(costs(row, x), row.smallest[std::size_t(x)], relief, beyond_.data(), excess, sums(row, x));
   }

   STEREO_INTO_CLONES void winners(Row& row, int y, int first, int end) {
      for (int x = first; x < end; ++x) {
         const int lanes = Fixed > 0 ? Fixed : lanes_;
         Lane* const __restrict to = total_.data();
         const Lane* const __restrict from = sums(row, x);
         const Lane* const __restrict beyond = beyond_.data();
         if (matching_.path_above) shared_.from_above.add(x, costs(row, x), beyond, from, to);
         else
            for (int d = 0; d < lanes; ++d) to[d] = Lane(from[d] | beyond[d]);
         if (matching_.full_width) {
            row.winners[std::size_t(x)] = match_part(row, x, y);
            continue;
         }
         if (matching_.has_left_right_check()) fast::offer(row.other, x, to, lanes, matching_.ties);
         row.winners[std::size_t(x)] = match_pixel(x, y);
      }
      if (matching_.path_above) shared_.from_above.next_row(first, end);
   }

   /// With full_width: the winner of those candidates that lead to a window in the other image, or with a border cost
   /// of all that are searched.
   STEREO_INTO_CLONES int match_part(Row& row, int x, int y) {
      const block_matching::Matching costs = matching_.window_costs();
      const auto [first_inside, last_inside] = block_matching::searched_range(x, map_.width, costs);
      int first = first_inside, last = last_inside;
      if (matching_.has_border_cost()) {
         first = matching_.first_disparity;
         last = costs.last_searched();
         if (matching_.has_left_right_check()) {
            inside_ = total_;
            keep_between(inside_, first_inside, last_inside);
            fast::offer(row.other, x, inside_.data(), lanes_, matching_.ties);
         }
      }
      if (last < first) {
         const int d = matching_.ties == Ties::smallest ? 0 : matching_.disparities - 1;
         map_.at(x, y) = uint16_t(matching_.subpixel ? 16 * d : d);
         map_.valid_at(x, y) = 0;
         return d;
      }
      keep_between(total_, first, last);
      if (matching_.has_left_right_check() && !matching_.has_border_cost())
         fast::offer(row.other, x, total_.data(), lanes_, matching_.ties);
      const int winner = match_pixel(x, y);
      if (matching_.subpixel && (winner == first || winner == last)) map_.at(x, y) = uint16_t(16 * winner);
      if (winner < first_inside || winner > last_inside) map_.valid_at(x, y) = 0;  // with a border cost
      return winner;
   }
   STEREO_INTO_CLONES void keep_between(std::vector<Lane>& sums, int first, int last) const {
      for (int d = 0; d < matching_.disparities; ++d)
         if (d < first || d > last) sums[std::size_t(d)] = std::numeric_limits<Lane>::max();
   }

   /// Gives the winner.
   STEREO_INTO_CLONES int match_pixel(int x, int y) {
      const Lane* const sums = total_.data();
      const fast::PixelResult<Lane> pixel = fast::find_winner(sums, Fixed > 0 ? Fixed : lanes_, matching_.ties);
      const uint64_t close = uint64_t(pixel.smallest) + uint64_t(matching_.uniqueness_distance) - 1;
      fast::settle(map_, x, y, sums, lanes_, pixel, close, matching_);
      return pixel.winner;
   }

   STEREO_INTO_CLONES void check_left_right(const Row& row, int y) {
      for (int x = 0; x < map_.width; ++x) {
         const int winner = row.winners[std::size_t(x)], back = int(row.other.disparity[std::size_t(x + winner)]);
         if (std::abs(back - winner) > matching_.left_right_threshold) map_.valid_at(x, y) = 0;
      }
   }

   Shared<Pixel, Lane, Fixed>& shared_;
   const Matching& matching_;
   int lanes_;
   DisparityMap& map_;
   WindowCosts<Pixel, PixelCost, Sum, Fixed> window_costs_;
   std::vector<Lane> beyond_;  ///< [d]: all bits set behind the last disparity
   std::vector<Lane> total_;   ///< [d]: S
   std::vector<Lane> inside_;  ///< [d]: with a border cost, S of what leads to a window in the other image
   RowPathState<Lane, Fixed> from_left_, from_right_;
   std::vector<Row> rows_;  ///< of a band
};

/// Sizes that many cores have: the compiler unrolls loops over a fixed number of lanes.
STEREO_VECTOR_CLONES void match_8_8_64(Shared<uint8_t, uint8_t, 64>& shared) {
   Matcher<uint8_t, uint8_t, uint8_t, uint8_t, 64>(shared).match();
}
STEREO_VECTOR_CLONES void match_8_8_128(Shared<uint8_t, uint8_t, 128>& shared) {
   Matcher<uint8_t, uint8_t, uint8_t, uint8_t, 128>(shared).match();
}
// Window costs of 8, 16 and 32 bits, and paths of 8 and 16.
STEREO_VECTOR_CLONES void match_8_8(Shared<uint8_t, uint8_t, 0>& shared) {
   Matcher<uint8_t, uint8_t, uint8_t, uint8_t, 0>(shared).match();
}
STEREO_VECTOR_CLONES void match_16_8(Shared<uint8_t, uint8_t, 0>& shared) {
   Matcher<uint8_t, uint8_t, uint16_t, uint8_t, 0>(shared).match();
}
STEREO_VECTOR_CLONES void match_16_16(Shared<uint8_t, uint16_t, 0>& shared) {
   Matcher<uint8_t, uint8_t, uint16_t, uint16_t, 0>(shared).match();
}
STEREO_VECTOR_CLONES void match_32_16(Shared<uint8_t, uint16_t, 0>& shared) {
   Matcher<uint8_t, uint8_t, uint32_t, uint16_t, 0>(shared).match();
}
STEREO_VECTOR_CLONES void match_ssd(Shared<uint8_t, uint16_t, 0>& shared) {
   Matcher<uint8_t, uint16_t, uint32_t, uint16_t, 0>(shared).match();
}

// Pixels of more than 8 bits, but for census transforms.
STEREO_VECTOR_CLONES void match_deep(Shared<uint16_t, uint16_t, 0>& shared) {
   Matcher<uint16_t, uint16_t, uint32_t, uint16_t, 0>(shared).match();
}
STEREO_VECTOR_CLONES void match_deep_ssd(Shared<uint16_t, uint16_t, 0>& shared) {
   Matcher<uint16_t, uint32_t, uint32_t, uint16_t, 0>(shared).match();
}

/// One thread goes through the image row by row, and no row's costs leave the fast memory. Several take bands that are
/// long beside the rows of the window that each has to take in anew.
RowBands bands_of(const DisparityMap& map, const Matching& matching, int threads) {
   constexpr int kRows = 8, kColumns = 64;
   if (threads == 1) return {map.height, map.width, 1, map.width};
   return {map.height, map.width, std::min(std::max(kRows, matching.window_px), map.height), kColumns};
}

template <class Pixel>
DisparityMap match(const PixelRows<Pixel>& pixels, int image_width, const DeepImage& relief, const Matching& matching,
                   int threads) {
   const int lanes = (matching.disparities + kVector - 1) / kVector * kVector;
   DisparityMap map(map_width(image_width, matching), pixels.height, 0, matching.subpixel);
   if (matching.has_confidence()) map.confidence.assign(map.valid.size(), 0);
   const auto run = [&]<class Lane, int Fixed>(void (*match)(Shared<Pixel, Lane, Fixed>&)) {
      Shared<Pixel, Lane, Fixed> shared{
          pixels,
          matching,
          relief,
          lanes,
          map,
          bands_of(map, matching, threads),
          PathFromAbove<Lane, Fixed>(matching, matching.path_above ? map.width : 0, lanes)};
      fast::in_threads(std::min(threads, shared.bands.count()), [&](int) { match(shared); });
   };
   if constexpr (sizeof(Pixel) > 1) {
      run(matching.cost == Cost::ssd ? match_deep_ssd : match_deep);
   } else {
      const int64_t side_x = std::min(matching.window_px, pixels.columns),
                    side_y = std::min(matching.window_px, map.height);
      const int64_t window_cost = side_x * side_y * block_matching::largest_pixel_cost(matching.window_costs());
      const bool narrow_paths = PathBounds(matching).fit(8);
      if (matching.cost == Cost::ssd) run(match_ssd);
      else if (window_cost < 1 << 8 && narrow_paths && lanes == 64) run(match_8_8_64);
      else if (window_cost < 1 << 8 && narrow_paths && lanes == 128) run(match_8_8_128);
      else if (window_cost < 1 << 8 && narrow_paths) run(match_8_8);
      else if (window_cost < 1 << 16 && narrow_paths) run(match_16_8);
      else if (window_cost < 1 << 16) run(match_16_16);
      else run(match_32_16);
   }
   return map;
}

/// Either kind of image.
template <class Image>
DisparityMap match_images(const Image& left, const Image& right, const Matching& matching, int threads) {
   const DeepImage relief = matching.largest_relief() > 0 ? reliefs(right, matching) : DeepImage();
   if (matching.cost == Cost::census)
      return match(census_rows(left, right, matching, kVector, threads), left.width, relief, matching, threads);
   return match(pixel_rows(left, right, matching, kVector, threads), left.width, relief, matching, threads);
}

}  // namespace

DisparityMap match_paths(const GrayImage& left, const GrayImage& right, const Matching& matching, int threads) {
   return match_images(left, right, matching, threads);
}
DisparityMap match_paths(const DeepImage& left, const DeepImage& right, const Matching& matching, int threads) {
   return match_images(left, right, matching, threads);
}

}  // namespace stereo::semi_global
