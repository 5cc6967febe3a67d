// SPDX-License-Identifier: Apache-2.0
#include "models/fast_model.hpp"

#include "models/general_matcher.hpp"
#include "models/median.hpp"
#include "models/mirror.hpp"
#include "models/plain_matcher.hpp"
#include "models/prefilter.hpp"

namespace stereo {
namespace {

/// Steps 2 to 6, images prefiltered, the right one as reference.
DisparityMap match_filtered(const GrayImage& left, const GrayImage& right, const MatchingParameters& parameters) {
   DisparityMap map = fast::is_plain(parameters) ? fast::match_plain(left, right, parameters)
                                                 : fast::match_general(left, right, parameters);
   if (parameters.has_texture_check()) fast::check_texture(right, parameters, map);
   return map;
}

/// Steps 1 to 6, the right image as reference.
DisparityMap match_right(const GrayImage& left, const GrayImage& right, const MatchingParameters& parameters) {
   if (parameters.prefilter == Prefilter::none) return match_filtered(left, right, parameters);
   return match_filtered(fast::prefilter_xsobel(left, parameters.prefilter_cap),
                         fast::prefilter_xsobel(right, parameters.prefilter_cap), parameters);
}

}  // namespace

DisparityMap match_fast(const GrayImage& left, const GrayImage& right, const MatchingParameters& parameters) {
   check_matching_input(left, right, parameters);
   DisparityMap map = parameters.reference == Reference::right
                          ? match_right(left, right, parameters)
                          : mirrored(match_right(mirrored(right), mirrored(left), parameters));
   if (parameters.median) map = fast::median_3x3(map);
   return map;
}

}  // namespace stereo
