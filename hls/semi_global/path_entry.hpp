// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "semi_global/config.hpp"
#include "semi_global/row_order.hpp"
#include "support/move_fan.hpp"

namespace stereo::semi_global {

/// Where costs come to the paths. Behind it, nothing moves but with a valid column: the paths count columns, not
/// clocks. 2 clocks, so that addresses are registers when the memories are read for the column, which is clock 2.
template <const Config& C>
struct PathEntry {
   static constexpr int kClocks = 2;
   static constexpr int kWidth = C.output_width_px();
   using Order = RowOrder<kWidth, typename OfWidth<C, kWidth - 1>::Type>;

   // clock 1
   PathCost<C> next_cost[C.disparities];
   PixelTag next_tag;
   uint16_t next_column;  ///< of the map: where what comes from above is kept
   bool next_top;         ///< the first row of a frame
   Order order;           ///< where the row is turned round
   // clock 2
   PathCost<C> cost[C.disparities];
   PixelTag tag;
   // tag.valid for what each block has of every disparity
   MoveFan<C.disparities, 0> moves_costs;
   MoveFan<C.disparities, decltype(moves_costs)::kEnd> moves_left;
   MoveFan<C.disparities, decltype(moves_left)::kEnd> moves_above;
   MoveFan<C.disparities, decltype(moves_above)::kEnd> moves_right;
   MoveFan<C.disparities, decltype(moves_right)::kEnd> moves_turn;
   uint16_t column;
   bool top;
   uint16_t place;   ///< order.address
   PixelTag turned;  ///< of the row before, on its way back

   HLS_INLINE PathEntry() { start(*this); }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("next_cost", next_cost);
      visit("next_tag", next_tag);
      visit("next_column", next_column);
      visit("next_top", next_top);
      visit("order", order);
      visit("cost", cost);
      visit("tag", tag);
      visit("moves_costs", moves_costs);
      visit("moves_left", moves_left);
      visit("moves_above", moves_above);
      visit("moves_right", moves_right);
      visit("moves_turn", moves_turn);
      visit("column", column);
      visit("top", top);
      visit("place", place);
      visit("turned", turned);
   }

   template <class Slices, class Size = FixedSize<kWindowConfig<C>>>
   HLS_INLINE void clock(const Slices& slices, const Size& size = Size()) {
      HLS_UNROLL
      for (int d = 0; d < C.disparities; ++d) cost[d] = next_cost[d];
      tag = next_tag;
      moves_costs.clock(next_tag.valid);
      moves_left.clock(next_tag.valid);
      moves_above.clock(next_tag.valid);
      moves_right.clock(next_tag.valid);
      moves_turn.clock(next_tag.valid);
      column = next_column;
      top = next_top;
      place = order.address;
      turned = order.turned;

      const PixelTag& in = slices.shown_tag();
      slices.put(next_cost);
      next_tag = in;
      const bool comes = in.valid && in.map_column;
      const uint16_t beside = select<uint16_t>(in.first_column, 0, uint16_t(next_column + 1));
      next_column = at_most<kWidth - 1>(select<uint16_t>(comes, beside, next_column));
      next_top = select<bool>(comes && in.first_column, in.start_of_frame, next_top);
      order.clock(in, size);
   }
};

}  // namespace stereo::semi_global
