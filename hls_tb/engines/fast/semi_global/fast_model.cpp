// SPDX-License-Identifier: Apache-2.0
#include "engines/fast/semi_global/fast_model.hpp"

#include "definition/mirror.hpp"
#include "definition/semi_global/matching_input.hpp"
#include "engines/fast/median.hpp"
#include "engines/fast/postprocessing.hpp"
#include "engines/fast/semi_global/path_matcher.hpp"

namespace stereo::semi_global {

namespace {

template <class Image>
DisparityMap match(const Image& left, const Image& right, const Matching& matching, int threads) {
   check_matching_input(left, right, matching);
   DisparityMap map = matching.reference == Reference::right
                          ? match_paths(left, right, matching, threads)
                          : stereo::mirrored(match_paths(stereo::mirrored(right), stereo::mirrored(left),
                                                         mirrored(matching), threads));
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

}  // namespace stereo::semi_global
