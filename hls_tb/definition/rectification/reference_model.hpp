// SPDX-License-Identifier: Apache-2.0
// Rectification by definition (docs/rectification.md): plain loops and exact sums, nothing shared with hls/ but the
// options.
#pragma once

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <vector>

#include "definition/gray_image.hpp"
#include "rectification/warp.hpp"

namespace stereo::rectification {

/// From a pixel to its place in the camera's image, in 2^-offset_fraction_bits pixels.
struct Offset {
   int x = 0, y = 0;

   bool operator==(const Offset&) const = default;
};

/// One camera's table: node (i, j) belongs to the pixel in column i * grid_px and row j * grid_px, which may lie behind
/// the image.
struct Table {
   int columns = 0;
   int rows = 0;
   std::vector<Offset> nodes;

   Table() = default;
   /// Of images of a size; all offsets are 0.
   Table(const Warp& warp, int image_width, int image_height)
       : columns(warp.nodes_along(image_width)),
         rows(warp.nodes_along(image_height)),
         nodes(std::size_t(columns) * std::size_t(rows)) {}

   Offset& at(int i, int j) { return nodes[std::size_t(j) * std::size_t(columns) + std::size_t(i)]; }
   const Offset& at(int i, int j) const { return nodes[std::size_t(j) * std::size_t(columns) + std::size_t(i)]; }
};

/// In the camera's image, in 2^-weight_bits pixels.
struct SourcePlace {
   int x = 0, y = 0;
};

SourcePlace source_place(const Table& table, const Warp& warp, int x, int y);

/// The rectified image, of the size of the camera's. Pixel: uint8_t or uint16_t, of which the camera's image has values
/// of warp.pixel_bits, as the result has. Throws std::invalid_argument where it has larger ones, and where the table is
/// not one of such images.
template <class Pixel>
RasterImage<Pixel> rectified(const RasterImage<Pixel>& image, const Table& table, const Warp& warp);

/// How far above and below its own row a pixel has a tap inside the image, both at least 0. With rows_above and
/// rows_below as large no tap is left out.
struct RowsNeeded {
   int above = 0, below = 0;
};
RowsNeeded rows_needed(const Table& table, const Warp& warp, int image_width, int image_height);

}  // namespace stereo::rectification
