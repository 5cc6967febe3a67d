// SPDX-License-Identifier: Apache-2.0
#include "engines/fast/trellis/fast_model.hpp"

#include "definition/mirror.hpp"
#include "definition/semi_global/matching_input.hpp"
#include "definition/trellis/matching_input.hpp"
#include "engines/fast/bands.hpp"
#include "engines/fast/median.hpp"
#include "engines/fast/postprocessing.hpp"
#include "engines/fast/semi_global/path_costs.hpp"

namespace stereo::trellis {
namespace {

constexpr int kVector = 32;

/// Rows of a map, one after the other. The costs come from the mirrored pair, whose reference is the right image: its
/// last column is our first.
template <class Pixel, class PixelCost>
class Matcher {
  public:
   STEREO_INTO_CLONES Matcher(const semi_global::PixelRows<Pixel>& pixels, const semi_global::Matching& costs,
                              const Matching& matching, DisparityMap& map)
       : matching_(matching),
         lanes_((matching.disparities + kVector - 1) / kVector * kVector),
         map_(map),
         window_costs_(pixels, costs, lanes_),
         costs_(std::size_t(map.width) * std::size_t(lanes_)),
         smallest_(std::size_t(map.width)),
         // E stands between guards: no state is below the first one or beyond the last one.
         path_(std::size_t(2 * (lanes_ + 2 * kGuard))),
         dropped_(std::size_t(lanes_)),
         far_(std::size_t(lanes_)),
         decisions_(costs_.size()) {}

   STEREO_INTO_CLONES void match(int first, int end) {
      window_costs_.go_to(first);
      for (int y = first; y < end; ++y) {
         window_costs_.next_row(costs_.data(), smallest_.data());
         trace_back(y, forward());
      }
   }

  private:
   static constexpr int kGuard = 256;
   static constexpr int kNever = 1 << 30;

   STEREO_INTO_CLONES const uint16_t* costs(int x) const {
      return costs_.data() + std::ptrdiff_t(map_.width - 1 - x) * lanes_;
   }
   STEREO_INTO_CLONES int* path(int x) { return path_.data() + std::ptrdiff_t(x % 2) * (lanes_ + 2 * kGuard) + kGuard; }

   /// E of the last column.
   STEREO_INTO_CLONES const int* forward() {
      const int states = matching_.disparities, gamma = matching_.drop_cost, omega = matching_.occlusion_cost;
      std::fill(path_.begin(), path_.end(), kNever);
      for (int d = 0; d < states; ++d) {
         path(0)[d] = costs(0)[d];
         dropped_[std::size_t(d)] = costs(0)[d] + gamma;
         far_[std::size_t(d)] = 0;
      }
      for (int x = 1; x < map_.width; ++x) {
         const uint16_t* const __restrict c = costs(x);
         const int* const __restrict before = path(x - 1);
         int* const __restrict here = path(x);
         int* const __restrict dropped = dropped_.data();
         int* const __restrict far = far_.data();
         uint8_t* const __restrict decision = decisions_.data() + std::ptrdiff_t(x) * lanes_;
         for (int d = 0; d < states; ++d) {
            const int stay = before[d], drop = dropped[d], gap = before[d - 1] + omega;
            const int kept = std::min(stay, drop) + c[d], code = stay <= drop ? 0 : 1 + far[d];
            here[d] = std::min(kept, gap);
            decision[d] = uint8_t(gap < kept ? 3 : code);
         }
         const int* const __restrict above = before + 1;
         const int* const __restrict beyond = before + matching_.far_drop;
         for (int d = 0; d < states; ++d) {
            dropped[d] = std::min(above[d], beyond[d]) + gamma + c[d];
            far[d] = beyond[d] < above[d] ? 1 : 0;
         }
         // The last state has no neighbour above: it takes its own.
         const std::size_t last = std::size_t(states) - 1;
         dropped_[last] = before[last] + gamma + c[last];
         far_[last] = 0;
      }
      return path(map_.width - 1);
   }

   STEREO_INTO_CLONES void trace_back(int y, const int* last) {
      int state = int(std::min_element(last, last + matching_.disparities) - last), falls = 0;
      for (int x = map_.width - 1; x >= 0; --x) {
         const int decision =
             falls != 0 || x == 0 ? 0 : decisions_[std::size_t(x) * std::size_t(lanes_) + std::size_t(state)];
         map_.at(x, y) = decision == 3 ? kOccluded : uint16_t(state);
         state += falls == 1 ? 1 : falls == 2 ? matching_.far_drop : decision == 3 ? -1 : 0;
         falls = decision == 3 ? 0 : decision;
      }
      uint16_t left = 0;
      for (int x = 0; x < map_.width; ++x) {
         const bool is_occluded = map_.at(x, y) == kOccluded;
         if (is_occluded) map_.at(x, y) = left;
         left = map_.at(x, y);
         map_.valid_at(x, y) = is_occluded && matching_.mark_occluded ? 0 : 1;
      }
   }

   static constexpr uint16_t kOccluded = 0xffff;

   const Matching& matching_;
   int lanes_;
   DisparityMap& map_;
   semi_global::WindowCosts<Pixel, PixelCost, uint32_t, 0> window_costs_;
   std::vector<uint16_t> costs_, smallest_;
   std::vector<int> path_;           ///< E of two columns
   std::vector<int> dropped_, far_;  ///< P, and whether its drop was a far one
   std::vector<uint8_t> decisions_;  ///< [x][d]
};

using ByteRows = semi_global::PixelRows<uint8_t>;
using DeepRows = semi_global::PixelRows<uint16_t>;
STEREO_VECTOR_CLONES void match_bytes(const ByteRows& pixels, const semi_global::Matching& costs,
                                      const Matching& matching, DisparityMap& map, int first, int end) {
   Matcher<uint8_t, uint8_t>(pixels, costs, matching, map).match(first, end);
}
STEREO_VECTOR_CLONES void match_squares(const ByteRows& pixels, const semi_global::Matching& costs,
                                        const Matching& matching, DisparityMap& map, int first, int end) {
   Matcher<uint8_t, uint16_t>(pixels, costs, matching, map).match(first, end);
}
STEREO_VECTOR_CLONES void match_deep(const DeepRows& pixels, const semi_global::Matching& costs,
                                     const Matching& matching, DisparityMap& map, int first, int end) {
   Matcher<uint16_t, uint16_t>(pixels, costs, matching, map).match(first, end);
}
STEREO_VECTOR_CLONES void match_deep_squares(const DeepRows& pixels, const semi_global::Matching& costs,
                                             const Matching& matching, DisparityMap& map, int first, int end) {
   Matcher<uint16_t, uint32_t>(pixels, costs, matching, map).match(first, end);
}

template <class Rows>
using MatchRows = void (*)(const Rows&, const semi_global::Matching&, const Matching&, DisparityMap&, int, int);
template <class Rows>
DisparityMap matched(const Rows& pixels, const semi_global::Matching& costs, const Matching& matching, int threads,
                     MatchRows<Rows> match) {
   DisparityMap map(pixels.columns, pixels.height);
   fast::for_each_band(map.height, threads,
                       [&](int first, int end) { match(pixels, costs, matching, map, first, end); });
   if (matching.has_confidence()) map.confidence.assign(map.valid.size(), 0);  // there is no runner-up
   fast::post_process(map, Reference::left, matching, threads);
   return matching.median ? fast::median_3x3(map, threads) : map;
}

/// By the type of what is compared.
DisparityMap match_rows(const ByteRows& pixels, const semi_global::Matching& costs, const Matching& matching,
                        int threads) {
   return matched(pixels, costs, matching, threads, matching.cost == Cost::ssd ? match_squares : match_bytes);
}
DisparityMap match_rows(const DeepRows& pixels, const semi_global::Matching& costs, const Matching& matching,
                        int threads) {
   return matched(pixels, costs, matching, threads, matching.cost == Cost::ssd ? match_deep_squares : match_deep);
}

template <class Image>
DisparityMap match_images(const Image& left, const Image& right, const Matching& matching, int threads) {
   check_matching_input(left, right, matching);
   const semi_global::Matching costs = semi_global::mirrored(matching.path_costs());
   const Image mirrored_right = stereo::mirrored(right), mirrored_left = stereo::mirrored(left);
   if (matching.cost == Cost::census)
      return match_rows(semi_global::census_rows(mirrored_right, mirrored_left, costs, kVector, threads), costs,
                        matching, threads);
   return match_rows(semi_global::pixel_rows(mirrored_right, mirrored_left, costs, kVector, threads), costs, matching,
                     threads);
}

}  // namespace

DisparityMap match_fast(const GrayImage& left, const GrayImage& right, const Matching& matching, int threads) {
   // What the prefilter gives may need the bits that the pixels do not.
   if (matching.pixel_bits > 8) return match_images(widened(left), widened(right), matching, threads);
   return match_images(left, right, matching, threads);
}
DisparityMap match_fast(const DeepImage& left, const DeepImage& right, const Matching& matching, int threads) {
   return match_images(left, right, matching, threads);
}

}  // namespace stereo::trellis
