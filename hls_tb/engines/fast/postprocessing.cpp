// SPDX-License-Identifier: Apache-2.0
// The neighbours of a row are counted offset by offset, each in a loop over the columns without branches; a margin of
// pixels that are like no other stands around the map. Holes are found once a row, from valid pixel to valid pixel.
#include "engines/fast/postprocessing.hpp"

#include <algorithm>
#include <cstdlib>

#include "engines/fast/bands.hpp"
#include "engines/fast/vector_clones.hpp"

namespace stereo::fast {
namespace {

constexpr int kColumns = 6, kRows = 2;  ///< of the window, on each side
constexpr int16_t kNone = -100;         ///< like no whole disparity

/// Whole disparities with a margin on all sides.
class WholeDisparities {
  public:
   explicit WholeDisparities(const DisparityMap& map)
       : stride_(map.width + 2 * kColumns), values_(std::size_t(stride_) * std::size_t(map.height + 2 * kRows), kNone) {
      const int half = map.steps_per_pixel() / 2, shift = map.subpixel ? 4 : 0;
      for (int y = 0; y < map.height; ++y)
         for (int x = 0; x < map.width; ++x)
            if (map.valid_at(x, y)) values_[index(x, y)] = int16_t((map.at(x, y) + half) >> shift);
   }
   const int16_t* row(int y) const { return values_.data() + index(0, y); }

  private:
   std::size_t index(int x, int y) const {
      return std::size_t(y + kRows) * std::size_t(stride_) + std::size_t(x + kColumns);
   }
   int stride_;
   std::vector<int16_t> values_;
};

STEREO_VECTOR_CLONES void count_like(uint8_t* __restrict count, const int16_t* __restrict centre,
                                     const int16_t* __restrict other, int width) {
   for (int x = 0; x < width; ++x) count[x] = uint8_t(count[x] + (uint16_t(other[x] - centre[x] + 1) <= 2 ? 1 : 0));
}

void filter_row(DisparityMap& map, int y, const WholeDisparities& whole, const PostProcessing& options,
                std::vector<uint8_t>& count) {
   std::fill(count.begin(), count.end(), uint8_t(0));
   for (int row = y - kRows; row <= y + kRows; ++row)
      for (int offset = -kColumns; offset <= kColumns; offset += 2)
         count_like(count.data(), whole.row(y), whole.row(row) + offset, map.width);
   const std::ptrdiff_t first = std::ptrdiff_t(y) * map.width;
   for (int x = 0; x < map.width; ++x) {
      uint8_t& valid = map.valid[std::size_t(first + x)];
      valid = valid != 0 && count[std::size_t(x)] >= options.support_threshold ? 1 : 0;
      if (!options.has_confidence()) continue;
      uint8_t& confidence = map.confidence[std::size_t(first + x)];
      confidence = valid != 0 ? uint8_t(options.confidence_of(count[std::size_t(x)], confidence)) : uint8_t(0);
   }
}

/// What stands in the columns left+1 ... right-1 of a row.
void fill_hole(uint16_t* row, int left, int right, Reference reference, int steps) {
   const uint16_t before = row[left], after = row[right];
   const int hole = right - left - 1;
   const bool from_left = reference == Reference::left;
   // Left of a near object the left image shows what the right one does not; the right image, on its right.
   const int step = from_left ? after - before : before - after;
   const int rest = step >= 0 ? std::max(0, hole - step / steps) : hole;  // what no step of the disparity hides
   const int of_near = rest / 2;
   const int split = from_left ? right - of_near : left + 1 + of_near;  // the first column of what is on the right
   std::fill(row + left + 1, row + split, before);
   std::fill(row + split, row + right, after);
}

void fill_rows(DisparityMap& map, Reference reference) {
   map.filled.assign(map.valid.size(), 0);
   bool has_values = false;
   for (int y = 0; y < map.height; ++y) {
      const std::ptrdiff_t first = std::ptrdiff_t(y) * map.width;
      uint16_t* const row = map.disparity.data() + first;
      const uint8_t* const valid = map.valid.data() + first;
      int last = -1;
      for (int x = 0; x < map.width; ++x) {
         if (valid[x] == 0) continue;
         if (last < 0) std::fill(row, row + x, row[x]);
         else fill_hole(row, last, x, reference, map.steps_per_pixel());
         last = x;
      }
      if (last >= 0) std::fill(row + last + 1, row + map.width, row[last]);
      else if (y > 0) std::copy(row - map.width, row, row);
      has_values = has_values || last >= 0;
      for (int x = 0; x < map.width; ++x) map.filled_at(x, y) = has_values && valid[x] == 0 ? 1 : 0;
   }
}

}  // namespace

void post_process(DisparityMap& map, Reference reference, const PostProcessing& options, int threads) {
   if (options.has_support_filter()) {
      const WholeDisparities whole(map);
      for_each_band(map.height, threads, [&](int first, int end) {
         std::vector<uint8_t> count(std::size_t(map.width));
         for (int y = first; y < end; ++y) filter_row(map, y, whole, options, count);
      });
   }
   if (options.fill_holes) fill_rows(map, reference);
}

}  // namespace stereo::fast
