// SPDX-License-Identifier: Apache-2.0
#include "definition/trellis/matching_input.hpp"

#include <stdexcept>

#include "definition/block_matching/matching_input.hpp"
#include "definition/semi_global/matching_input.hpp"

namespace stereo::trellis {
namespace {

template <class Image>
void check_input(const Image& left, const Image& right, const Matching& matching) {
   if (const Sentence problem = matching.problem(); !problem.empty()) throw std::invalid_argument(problem.text);
   semi_global::check_matching_input(left, right, matching.path_costs());
}

}  // namespace

void check_matching_input(const GrayImage& left, const GrayImage& right, const Matching& matching) {
   check_input(left, right, matching);
}
void check_matching_input(const DeepImage& left, const DeepImage& right, const Matching& matching) {
   check_input(left, right, matching);
}

MapGeometry map_geometry(const Matching& matching, int image_width) {
   MapGeometry geometry = semi_global::map_geometry(matching.path_costs(), image_width);
   geometry.has_check = matching.has_check();
   return geometry;
}

std::string describe(const Matching& matching) {
   return block_matching::describe(matching.path_costs().window_costs()) + ", drop " +
          std::to_string(matching.drop_cost) + " or by " + std::to_string(matching.far_drop) + ", occlusion " +
          std::to_string(matching.occlusion_cost);
}

}  // namespace stereo::trellis
