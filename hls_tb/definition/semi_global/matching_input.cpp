// SPDX-License-Identifier: Apache-2.0
#include "definition/semi_global/matching_input.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <stdexcept>
#include <utility>

#include "definition/block_matching/matching_input.hpp"

namespace stereo::semi_global {
namespace {

template <class Image>
void check_input(const Image& left, const Image& right, const Matching& matching) {
   if (const Sentence problem = matching.problem(); !problem.empty()) throw std::invalid_argument(problem.text);
   block_matching::check_matching_input(left, right, matching.window_costs());
}

}  // namespace

void check_matching_input(const GrayImage& left, const GrayImage& right, const Matching& matching) {
   check_input(left, right, matching);
}
void check_matching_input(const DeepImage& left, const DeepImage& right, const Matching& matching) {
   check_input(left, right, matching);
}

Matching mirrored(Matching matching) {
   matching.reference = matching.reference == Reference::right ? Reference::left : Reference::right;
   std::swap(matching.path_left, matching.path_right);
   return matching;
}

int largest_path_cost(const Matching& matching) {
   // A window beyond 2^16 pixels only counts those in the image, but is far above any cap.
   const int64_t side = std::min(matching.window_px, 1 << 16);
   const int64_t window_cost = block_matching::largest_pixel_cost(matching.window_costs()) * side * side;
   return int(std::min<int64_t>(window_cost >> matching.cost_shift, matching.cost_cap));
}

template <class Pixel>
DeepImage reliefs(const RasterImage<Pixel>& right, const Matching& matching) {
   DeepImage relief(map_width(right.width, matching), right.height);
   const int first = map_geometry(matching, right.width).first_column;
   for (int y = 0; y < relief.height; ++y)
      for (int x = 1; x < relief.width; ++x) {
         const int difference = std::abs(int(right.at(first + x, y)) - int(right.at(first + x - 1, y)));
         relief.at(x, y) = uint16_t(std::min(difference >> matching.relief_shift(), matching.largest_relief()));
      }
   return relief;
}
template DeepImage reliefs(const GrayImage&, const Matching&);
template DeepImage reliefs(const DeepImage&, const Matching&);

int map_width(int width_px, const Matching& matching) {
   const block_matching::Matching costs = matching.window_costs();
   return matching.full_width ? block_matching::map_width(width_px, costs)
                              : block_matching::cost_columns(width_px, costs);
}

MapGeometry map_geometry(const Matching& matching, int image_width) {
   MapGeometry geometry = block_matching::map_geometry(matching.window_costs(), image_width);
   geometry.width = map_width(image_width, matching);
   // the one that block matching leaves out
   if (matching.reference == Reference::left && !matching.full_width) --geometry.first_column;
   geometry.has_check = matching.has_check();
   return geometry;
}

std::string describe(const Matching& matching) {
   return block_matching::describe(matching.window_costs()) + ", P1 " + std::to_string(matching.p1) + ", P2 " +
          std::to_string(matching.p2);
}

}  // namespace stereo::semi_global
