// SPDX-License-Identifier: Apache-2.0
#include "definition/rectification/reference_model.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "definition/pixel_range.hpp"

namespace stereo::rectification {
namespace {

/// The largest whole number that is not above numerator / denominator.
int64_t floor_divided(int64_t numerator, int64_t denominator) {
   const int64_t quotient = numerator / denominator;
   return numerator % denominator < 0 ? quotient - 1 : quotient;
}

/// To the nearest whole number, halves up.
int64_t rounded(int64_t numerator, int64_t denominator) {
   return floor_divided(2 * numerator + denominator, 2 * denominator);
}

int64_t power_of_two(int exponent) { return int64_t(1) << exponent; }

/// The four neighbours of a place, and how much of each other pixel it has, in 2^-weight_bits.
struct Neighbours {
   int column, row;
   int64_t right, lower;
};

Neighbours neighbours(const SourcePlace& place, const Warp& warp) {
   const int64_t unit = power_of_two(warp.weight_bits);
   const int64_t column = floor_divided(place.x, unit), row = floor_divided(place.y, unit);
   return {int(column), int(row), place.x - column * unit, place.y - row * unit};
}

}  // namespace

SourcePlace source_place(const Table& table, const Warp& warp, int x, int y) {
   const int64_t grid = warp.grid_px, i = x / grid, j = y / grid, u = x % grid, v = y % grid;
   int64_t sum_x = 0, sum_y = 0;
   for (int down = 0; down < 2; ++down)
      for (int across = 0; across < 2; ++across) {
         const Offset& node = table.at(int(i) + across, int(j) + down);
         const int64_t weight = (across == 0 ? grid - u : u) * (down == 0 ? grid - v : v);
         sum_x += weight * node.x;
         sum_y += weight * node.y;
      }
   // The sums are in 2^-F / G^2 pixels.
   const int64_t unit = power_of_two(warp.weight_bits);
   const int64_t divisor = grid * grid * power_of_two(warp.offset_fraction_bits);
   return {int(x * unit + rounded(sum_x * unit, divisor)), int(y * unit + rounded(sum_y * unit, divisor))};
}

template <class Pixel>
RasterImage<Pixel> rectified(const RasterImage<Pixel>& image, const Table& table, const Warp& warp) {
   if (const Sentence problem = warp.problem(); !problem.empty()) throw std::invalid_argument(problem.text);
   if (table.columns != warp.nodes_along(image.width) || table.rows != warp.nodes_along(image.height))
      throw std::invalid_argument("a table of " + size_text(table.columns, table.rows) +
                                  " nodes is none of an image of " + size_text(image));
   if (const std::string problem = beyond_range(image, warp.pixel_bits); !problem.empty())
      throw std::invalid_argument("the image " + problem);
   RasterImage<Pixel> result(image.width, image.height);
   for (int y = 0; y < image.height; ++y)
      for (int x = 0; x < image.width; ++x) {
         const Neighbours from = neighbours(source_place(table, warp, x, y), warp);
         const auto tap = [&](int column, int row) -> int64_t {
            const bool inside = column >= 0 && column < image.width && row >= 0 && row < image.height;
            const bool kept = row >= y - warp.rows_above && row <= y + warp.rows_below;
            return inside && kept ? image.at(column, row) : 0;
         };
         const int64_t unit = power_of_two(warp.weight_bits), left = unit - from.right, upper = unit - from.lower;
         const int64_t sum = left * upper * tap(from.column, from.row) +
                             from.right * upper * tap(from.column + 1, from.row) +
                             left * from.lower * tap(from.column, from.row + 1) +
                             from.right * from.lower * tap(from.column + 1, from.row + 1);
         result.at(x, y) = Pixel(rounded(sum, unit * unit));
      }
   return result;
}

template GrayImage rectified(const GrayImage&, const Table&, const Warp&);
template DeepImage rectified(const DeepImage&, const Table&, const Warp&);

RowsNeeded rows_needed(const Table& table, const Warp& warp, int image_width, int image_height) {
   RowsNeeded needed;
   for (int y = 0; y < image_height; ++y)
      for (int x = 0; x < image_width; ++x) {
         const Neighbours from = neighbours(source_place(table, warp, x, y), warp);
         if (from.column < -1 || from.column >= image_width) continue;
         for (const int row : {from.row, from.row + 1}) {
            if (row < 0 || row >= image_height) continue;
            needed.above = std::max(needed.above, y - row);
            needed.below = std::max(needed.below, row - y);
         }
      }
   return needed;
}

}  // namespace stereo::rectification
