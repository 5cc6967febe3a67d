// SPDX-License-Identifier: Apache-2.0
#include "engines/fast/phase_correlation/fast_model.hpp"

#include "definition/mirror.hpp"
#include "definition/phase_correlation/matching_input.hpp"
#include "engines/fast/block_matching/general_matcher.hpp"
#include "engines/fast/median.hpp"
#include "engines/fast/phase_correlation/phase_codes.hpp"
#include "engines/fast/postprocessing.hpp"

namespace stereo::phase_correlation {
namespace {

/// All but post-processing and median, the right image as reference.
template <class Image>
DisparityMap match_right(const Image& left, const Image& right, const Matching& matching, int threads) {
   return block_matching::match_codes(fast::weighted_phase_codes(left, matching.phase_scales),
                                      fast::weighted_phase_codes(right, matching.phase_scales), left.width,
                                      matching.block_matching(), threads);
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
   return match(left, right, matching, threads);
}
DisparityMap match_fast(const DeepImage& left, const DeepImage& right, const Matching& matching, int threads) {
   return match(left, right, matching, threads);
}

}  // namespace stereo::phase_correlation
