// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <type_traits>

#include "cost/centre_tag.hpp"
#include "cost/costs.hpp"
#include "support/matching_options.hpp"
#include "support/memory_bank.hpp"
#include "support/packed.hpp"
#include "support/ring.hpp"

namespace stereo {

/// Aggregates the last B column costs into window costs, for P windows and `Count` disparities. 1 clock; a window is
/// complete when its last column has come in.
///
/// Partial sums move on with the columns, so that each clock adds once: sum of 1, of 2, ... of B-1 columns, and the
/// output is the sum of B. Registers: P x Count x (B-1) partial sums and P x Count window costs.
template <const auto& C, int Count>
struct WindowSum {
   static constexpr int kClocks = 1;
   static constexpr int kMemories = 0;
   static constexpr int kPixels = C.pixels_per_clock;
   static constexpr int kPartials = C.window_px - 1;
   using Sum = WindowCost<C>;

   Sum partial[kPixels][kPartials][Count];  ///< [p][j]: the last j+1 column costs
   CentreTag<C> centre;
   Sum sum[kPixels][Count];  ///< S(x,y,d)
   PixelTag tag;             ///< of the window's centre

   template <class Source, int Number>
   HLS_INLINE WindowSum(Source&, MemoryId<Number>) {
      start(*this);
   }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("partial", partial);
      visit("centre", centre);
      visit("sum", sum);
      visit("tag", tag);
   }

   /// The tag of the column that the next sum has.
   template <class Column>
   HLS_INLINE const PixelTag& newest(const Column& cost) const {
      return cost.tag;
   }

   template <class Column>
   HLS_INLINE void clock(const Column& cost) {
      const bool move = cost.tag.valid;
      HLS_UNROLL
      for (int p = 0; p < kPixels; ++p) {
         HLS_UNROLL
         for (int i = 0; i < Count; ++i) {
            const Sum newest = cost.column[p][i];
            sum[p][i] = Sum(partial[p][kPartials - 1][i] + newest);
            HLS_UNROLL
            for (int j = kPartials - 1; j > 0; --j) {
               const Sum next = Sum(partial[p][j - 1][i] + newest);
               partial[p][j][i] = select<Sum>(move, next, partial[p][j][i]);
            }
            partial[p][0][i] = select<Sum>(move, newest, partial[p][0][i]);
         }
      }
      tag = centre.clock(cost.tag);
   }
};

/// The same window costs from those of the column before: plus the column that enters, minus the one that leaves.
/// 3 clocks. Memory: (B+1) x P x Count x bits of a column cost.
template <const auto& C, int Count>
struct RunningWindowSum {
   static constexpr int kClocks = 3;
   static constexpr int kPixels = C.pixels_per_clock;
   static constexpr int kCostBits = bits_for(C.largest_column_cost());
   using Pack = Packed<kCostBits, kPixels * Count>;
   using Word = typename Pack::Word;
   using Sum = WindowCost<C>;

   using Columns = Ring<Word, C.window_px + 1, Pack::kWords>;
   static constexpr int kMemories = Columns::kMemories;

   Columns ring;
   // clock 1
   Word leaving[Pack::kWords];
   ColumnCost<C> entering[kPixels][Count];
   PixelTag entering_tag;
   // clock 2
   int32_t change[kPixels][Count];
   PixelTag change_tag;
   // clock 3
   Sum sum[kPixels][Count];  ///< S(x,y,d)
   CentreTag<C> centre;
   PixelTag tag;

   template <class Source, int Number>
   HLS_INLINE RunningWindowSum(Source& memories, MemoryId<Number> first) : ring(memories, first) {
      start(*this);
   }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("ring", ring);
      visit("leaving", leaving);
      visit("entering", entering);
      visit("entering_tag", entering_tag);
      visit("change", change);
      visit("change_tag", change_tag);
      visit("sum", sum);
      visit("centre", centre);
      visit("tag", tag);
   }

   /// The tag of the column that the next sum has.
   template <class Column>
   HLS_INLINE const PixelTag& newest(const Column&) const {
      return change_tag;
   }

   template <class Column>
   HLS_INLINE void clock(const Column& cost) {
      HLS_UNROLL
      for (int p = 0; p < kPixels; ++p) {
         HLS_UNROLL
         for (int i = 0; i < Count; ++i) {
            const Sum before = select<Sum>(change_tag.first_cost, 0, sum[p][i]);  // each row starts with nothing
            const Sum after = Sum(before + change[p][i]) & kMask;
            sum[p][i] = select<Sum>(change_tag.valid, after, sum[p][i]);
            const typename Pack::Lane left = Pack::lane(leaving, p * Count + i);
            change[p][i] =
                int32_t(entering[p][i]) - int32_t(select<typename Pack::Lane>(entering_tag.leaves_window, left, 0));
         }
      }
      tag = centre.clock(change_tag);
      change_tag = entering_tag;
      take(cost);
   }

  private:
   static constexpr Sum kMask = Sum((uint64_t(1) << bits_for(C.largest_window_cost())) - 1);

   template <class Column>
   HLS_INLINE void take(const Column& cost) {
      typename Pack::Lane lanes[kPixels * Count];
      Word newest[Pack::kWords];
      HLS_UNROLL
      for (int p = 0; p < kPixels; ++p) {
         HLS_UNROLL
         for (int i = 0; i < Count; ++i) {
            lanes[p * Count + i] = typename Pack::Lane(cost.column[p][i]);
            entering[p][i] = cost.column[p][i];
         }
      }
      Pack::pack(lanes, newest);
      ring.clock(newest, cost.tag.valid, leaving);
      entering_tag = cost.tag;
   }
};

/// The block that sums columns into windows. Both have `sum`, `tag`, `clock(column block)` and kClocks.
template <const auto& C, int Count>
using WindowBlock =
    std::conditional_t<C.aggregation == Aggregation::recursive, RunningWindowSum<C, Count>, WindowSum<C, Count>>;

}  // namespace stereo
