// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rectification/bilinear.hpp"
#include "rectification/grid_place.hpp"
#include "rectification/table_write.hpp"

namespace stereo::rectification {

/// One camera's table, and from it the way from each pixel to its place in the camera's image. 10 clocks.
/// Memory: nodes x 2 offset_bits.
template <const Config& C>
struct Offsets {
   static constexpr int kBits = C.offset_bits;
   using Node = uint_of_bits<2 * kBits>;
   using Nodes = QuadMemory<Node, (C.table_columns() + 1) / 2 * 2, (C.table_rows() + 1) / 2 * 2>;
   using Between = Bilinear<kBits, C.grid_bits(), C.offset_shift()>;
   static constexpr int kClocks = Nodes::kClocks + Between::kClocks;
   static constexpr int kMemories = Nodes::kMemories;

   Nodes nodes;
   Between x, y;  ///< values in 2^-weight_bits pixels, reach_px() too large

   template <class Source, int First>
   HLS_INLINE Offsets(Source& memories, MemoryId<First> first) : nodes(memories, first) {}

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("nodes", nodes);
      visit("x", x);
      visit("y", y);
   }

   /// mine: `table` is of this camera.
   HLS_INLINE void clock(const GridPlace<C>& place, const TableWrite& table, bool mine) {
      Node ready[2][2];
      nodes.taps(ready);
      int32_t across[2][2], down[2][2];
      HLS_UNROLL
      for (int r = 0; r < 2; ++r) {
         HLS_UNROLL
         for (int c = 0; c < 2; ++c) {
            across[r][c] = int32_t(uint32_t(ready[r][c]) & kMask);
            down[r][c] = int32_t(uint32_t(ready[r][c]) >> kBits & kMask);
         }
      }
      x.clock(across, place.weight_x.oldest(), place.weight_y.oldest());
      y.clock(down, place.weight_x.oldest(), place.weight_y.oldest());
      nodes.clock(place.node, table.valid & mine, {table.column, table.row},
                  Node(kept(table.x) | kept(table.y) << kBits));
   }

  private:
   static constexpr uint32_t kMask = (1U << kBits) - 1;
   static constexpr uint32_t kSign = 1U << (kBits - 1);

   /// Offsets are kept without sign, 2^(kBits - 1) too large, as the lowering knows no right shift of negative numbers.
   static HLS_INLINE uint32_t kept(int16_t offset) { return (uint32_t(offset) & kMask) ^ kSign; }
};

}  // namespace stereo::rectification
