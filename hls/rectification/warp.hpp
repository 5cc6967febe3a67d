// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "support/hls_support.hpp"
#include "support/options.hpp"

namespace stereo::rectification {

/// What rectification computes: docs/rectification.md defines each option. The model takes it with images of any size.
struct Warp {
   int pixel_bits = 8;            ///< grey values are 0 ... 2^pixel_bits - 1; 8, 10 or 12
   int grid_px = 16;              ///< G: columns and rows between nodes of the table: 4, 8, 16, 32 or 64
   int offset_bits = 16;          ///< of each of a node's two offsets, 8 ... 16
   int offset_fraction_bits = 6;  ///< F: offsets are in 2^-F pixels, 4 ... 8
   int weight_bits = 5;           ///< B: places in the camera's image are in 2^-B pixels, 1 ... 8
   int rows_above = 16;           ///< how far above its own row a pixel's taps may lie, 0 ... 255
   int rows_below = 16;           ///< and how far below it

   constexpr int grid_bits() const { return bits_for(grid_px - 1); }
   /// Nodes along a side of an image: the last one stands behind its last pixel.
   constexpr int nodes_along(int side_px) const { return ((side_px - 1) >> grid_bits()) + 2; }
   /// A sum of four offsets is so many bits finer than a place.
   constexpr int offset_shift() const { return 2 * grid_bits() + offset_fraction_bits - weight_bits; }
   /// No place lies farther to the left of its pixel or above it.
   constexpr int reach_px() const { return 1 << (offset_bits - 1 - offset_fraction_bits); }
   constexpr int largest_offset() const { return (1 << (offset_bits - 1)) - 1; }
   /// Of one camera.
   constexpr int table_bits(int width_px, int height_px) const {
      return nodes_along(width_px) * nodes_along(height_px) * 2 * offset_bits;
   }
   /// A pixel's row leaves when so many further rows have come in: those that its taps reach, and one more, as taps may
   /// lie to its right.
   constexpr int lag_rows() const { return rows_below + 1; }
   /// Those that taps reach, and the one that comes in; even, as two memories share them.
   constexpr int buffered_rows() const { return (rows_above + lag_rows() + 1 + 1) / 2 * 2; }

   template <class Self, class Visitor>
   static constexpr void options(Self& self, Visitor& visit) {
      visit("pixel_bits", self.pixel_bits, 8, 12, "the number of bits of a pixel");
      visit("grid_px", self.grid_px, 4, 64, "the distance of the table's nodes");
      visit("offset_bits", self.offset_bits, 8, 16, "the number of bits of an offset");
      visit("offset_fraction_bits", self.offset_fraction_bits, 4, 8, "the number of fraction bits of an offset");
      visit("weight_bits", self.weight_bits, 1, 8, "the number of bits of the weights");
      visit("rows_above", self.rows_above, 0, 255, "the number of rows above");
      visit("rows_below", self.rows_below, 0, 255, "the number of rows below");
   }

   /// Why nothing can be rectified with these options; empty when it can.
   constexpr Sentence problem() const {
      if (const Sentence limit = first_beyond_limits(*this); !limit.empty()) return limit;
      if (offset_bits <= offset_fraction_bits) return "an offset must have more bits than fraction bits";
      if (pixel_bits % 2 != 0) {
         Sentence sentence = "the number of bits of a pixel is ";
         return sentence << pixel_bits << " but must be 8, 10 or 12";
      }
      if ((grid_px & (grid_px - 1)) == 0) return {};
      Sentence sentence = "the distance of the table's nodes is ";
      return sentence << grid_px << " but must be a power of two";
   }
};

}  // namespace stereo::rectification
