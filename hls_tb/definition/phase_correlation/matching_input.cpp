// SPDX-License-Identifier: Apache-2.0
#include "definition/phase_correlation/matching_input.hpp"

#include <stdexcept>

#include "definition/block_matching/matching_input.hpp"

namespace stereo::phase_correlation {

namespace {

template <class Image>
void check_input(const Image& left, const Image& right, const Matching& matching) {
   if (const Sentence problem = matching.problem(); !problem.empty()) throw std::invalid_argument(problem.text);
   block_matching::check_matching_input(left, right, matching.block_matching());
}

}  // namespace

void check_matching_input(const GrayImage& left, const GrayImage& right, const Matching& matching) {
   check_input(left, right, matching);
}
void check_matching_input(const DeepImage& left, const DeepImage& right, const Matching& matching) {
   check_input(left, right, matching);
}

MapGeometry map_geometry(const Matching& matching, int image_width) {
   return block_matching::map_geometry(matching.block_matching(), image_width);
}

std::string describe(const Matching& matching) {
   return block_matching::describe(matching.block_matching()) + ", phase of " + std::to_string(matching.phase_scales) +
          (matching.phase_scales == 1 ? " scale" : " scales");
}

}  // namespace stereo::phase_correlation
