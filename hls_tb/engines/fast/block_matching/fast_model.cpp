// SPDX-License-Identifier: Apache-2.0
#include "engines/fast/block_matching/fast_model.hpp"

#include "definition/block_matching/matching_input.hpp"
#include "definition/mirror.hpp"
#include "engines/fast/block_matching/general_matcher.hpp"
#include "engines/fast/block_matching/plain_matcher.hpp"
#include "engines/fast/block_matching/texture.hpp"
#include "engines/fast/median.hpp"
#include "engines/fast/postprocessing.hpp"
#include "engines/fast/prefilter.hpp"

namespace stereo::block_matching {
namespace {

DisparityMap match_windows(const GrayImage& left, const GrayImage& right, const Matching& matching, int threads) {
   return is_plain(matching) ? match_plain(left, right, matching, threads)
                             : match_general(left, right, matching, threads);
}
DisparityMap match_windows(const DeepImage& left, const DeepImage& right, const Matching& matching, int threads) {
   return match_general(left, right, matching, threads);
}

/// Steps 2 to 6, images prefiltered, the right one as reference.
template <class Image>
DisparityMap match_filtered(const Image& left, const Image& right, const Matching& matching, int threads) {
   DisparityMap map = match_windows(left, right, matching, threads);
   if (matching.has_texture_check()) check_texture(right, matching, map, threads);
   return map;
}

/// Steps 1 to 6, the right image as reference.
template <class Image>
DisparityMap match_right(const Image& left, const Image& right, const Matching& matching, int threads) {
   if (matching.prefilter == Prefilter::none) return match_filtered(left, right, matching, threads);
   return match_filtered(fast::prefilter_xsobel(left, matching.prefilter_cap, threads),
                         fast::prefilter_xsobel(right, matching.prefilter_cap, threads), matching, threads);
}

template <class Image>
DisparityMap match(const Image& left, const Image& right, const Matching& matching, int threads) {
   check_matching_input(left, right, matching);
   DisparityMap map = matching.reference == Reference::right
                          ? match_right(left, right, matching, threads)
                          : mirrored(match_right(mirrored(right), mirrored(left), matching, threads));
   fast::post_process(map, matching.reference, matching, threads);
   if (matching.median) map = fast::median_3x3(map, threads);
   return map;
}

}  // namespace

DisparityMap match_fast(const GrayImage& left, const GrayImage& right, const Matching& matching, int threads) {
   // What the prefilter gives may need the bits that the pixels do not.
   if (matching.pixel_bits > 8) return match(widened(left), widened(right), matching, threads);
   return match(left, right, matching, threads);
}
DisparityMap match_fast(const DeepImage& left, const DeepImage& right, const Matching& matching, int threads) {
   return match(left, right, matching, threads);
}

}  // namespace stereo::block_matching
