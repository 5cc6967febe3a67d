// SPDX-License-Identifier: Apache-2.0
#include "program/postprocessing/speckles.hpp"

#include <cmath>
#include <cstdlib>

namespace stereo::app {
namespace {

/// Goes from pixel to pixel of one joined set at a time.
class Sets {
  public:
   Sets(const DisparityMap& map, int largest_step) : map_(map), step_(largest_step), seen_(map.valid.size()) {}

   /// The joined set of a pixel with a value that no set has yet; else none.
   const std::vector<std::size_t>& from(std::size_t first) {
      set_.clear();
      take(first);
      for (std::size_t i = 0; i < set_.size(); ++i) join_neighbours(set_[i]);
      return set_;
   }

  private:
   void take(std::size_t pixel) {
      if (seen_[pixel] || !has_value(pixel)) return;
      seen_[pixel] = true;
      set_.push_back(pixel);
   }
   bool has_value(std::size_t pixel) const {
      return map_.valid[pixel] != 0 || (!map_.filled.empty() && map_.filled[pixel] != 0);
   }
   void join_neighbours(std::size_t pixel) {
      const auto width = std::size_t(map_.width);
      const std::size_t column = pixel % width;
      if (column > 0) join(pixel, pixel - 1);
      if (column + 1 < width) join(pixel, pixel + 1);
      if (pixel >= width) join(pixel, pixel - width);
      if (pixel + width < seen_.size()) join(pixel, pixel + width);
   }
   void join(std::size_t pixel, std::size_t neighbour) {
      if (std::abs(map_.disparity[pixel] - map_.disparity[neighbour]) <= step_) take(neighbour);
   }

   const DisparityMap& map_;
   int step_;
   std::vector<bool> seen_;
   std::vector<std::size_t> set_;
};

}  // namespace

void remove_speckles(DisparityMap& map, int window_px, int range_px) {
   const DisparityMap whole = map;
   Sets sets(whole, range_px * map.steps_per_pixel());
   for (std::size_t first = 0; first < whole.valid.size(); ++first) {
      const std::vector<std::size_t>& set = sets.from(first);
      if (set.size() > std::size_t(window_px)) continue;
      for (const std::size_t pixel : set) {
         map.valid[pixel] = 0;
         if (!map.filled.empty()) map.filled[pixel] = 0;
      }
   }
}

}  // namespace stereo::app
