// SPDX-License-Identifier: Apache-2.0
// Where the two search windows of a dynamic range stand, by definition (docs/algorithm.md, Y1 to Y5): one function for
// each step, plain loops. Every step takes the right image as reference.
#pragma once

#include <optional>
#include <vector>

#include "definition/disparity_map.hpp"
#include "definition/gray_image.hpp"
#include "dynamic_range/matching.hpp"

namespace stereo::dynamic_range {

/// A value for each block of 8x8 pixels.
template <class Value>
struct Blocks {
   int width = 0, height = 0;
   std::vector<Value> values;

   Blocks() = default;
   Blocks(int columns, int rows, Value value = Value())
       : width(columns), height(rows), values(std::size_t(columns) * std::size_t(rows), value) {}

   Value& at(int column, int row) { return values[std::size_t(row) * std::size_t(width) + std::size_t(column)]; }
   const Value& at(int column, int row) const {
      return values[std::size_t(row) * std::size_t(width) + std::size_t(column)];
   }
};

/// Disparities of the surfaces of a block, the lowest and the highest.
struct Range {
   int low = 0, high = 0;

   bool operator==(const Range&) const = default;
};

/// Y1. The means of 4x4 pixels; the last column stands `more_columns` times more.
GrayImage coarse_image(const GrayImage& image, int more_columns);
DeepImage coarse_image(const DeepImage& image, int more_columns);

/// Y2. The map of the coarse images, whole range, with its left/right check. As wide as the image by 4.
DisparityMap coarse_map(const GrayImage& left, const GrayImage& right, const Matching& matching);
DisparityMap coarse_map(const DeepImage& left, const DeepImage& right, const Matching& matching);

/// By how much the disparity of a neighbour may differ from that of a coarse pixel, in coarse disparities.
struct Agreement {
   int lowest = -1, highest = 1;
};
/// Of each neighbour. Other values than these are for tests.
struct NeighbourAgreement {
   Agreement left{}, right{}, above{}, below{};
};

/// Y3. What is known of each block.
Blocks<std::optional<Range>> block_ranges(const DisparityMap& coarse, const NeighbourAgreement& agreement = {});

/// Y4. The first disparity that each search window would like to have in a block.
struct Targets {
   Blocks<int> low, high;
};
Targets search_targets(const Blocks<std::optional<Range>>& ranges, const Matching& matching);

/// Y5. The first disparity that a search window has, for the columns 0 ... W-D of row y.
std::vector<int> window_bases(const Blocks<int>& targets, int y, int image_width, const Matching& matching);

}  // namespace stereo::dynamic_range
