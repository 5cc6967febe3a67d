// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "column_cost.hpp"
#include "ring.hpp"

namespace stereo {

/// Holds what the tags say of the columns that came after a window's centre, so that a window carries its centre's tag.
template <const StereoConfig& C>
struct CentreTag {
   static constexpr int kAfter = C.columns_after();
   static constexpr int kHeld = kAfter > 0 ? kAfter : 1;

   // [j]: of the column j+1 before the newest
   bool map_column[kHeld], output_column[kHeld], first_column[kHeld], start_of_frame[kHeld], end_of_line[kHeld];

   HLS_INLINE CentreTag() {
      fill(map_column, false);
      fill(output_column, false);
      fill(first_column, false);
      fill(start_of_frame, false);
      fill(end_of_line, false);
   }

   /// The centre's tag of the window that `newest` completes.
   HLS_INLINE PixelTag clock(const PixelTag& newest) {
      PixelTag centre;
      centre.valid = newest.valid;
      centre.map_column = shifted(map_column, newest.map_column, newest.valid);
      centre.output_column = shifted(output_column, newest.output_column, newest.valid);
      centre.first_column = shifted(first_column, newest.first_column, newest.valid);
      centre.start_of_frame = shifted(start_of_frame, newest.start_of_frame, newest.valid);
      centre.end_of_line = shifted(end_of_line, newest.end_of_line, newest.valid);
      return centre;
   }

  private:
   /// Takes in the newest flag; returns that of the centre.
   static HLS_INLINE bool shifted(bool (&held)[kHeld], bool newest, bool move) {
      const bool centre = kAfter > 0 ? held[kHeld - 1] : newest;
      HLS_UNROLL
      for (int j = kHeld - 1; j > 0; --j) held[j] = select<bool>(move, held[j - 1], held[j]);
      held[0] = select<bool>(move, newest, held[0]);
      return centre;
   }
};

/// Aggregates the last B column costs into window costs, for P windows and `Count` disparities. 1 clock; a window is
/// complete when its last column has come in.
///
/// Partial sums move on with the columns, so that each clock adds once: sum of 1, of 2, ... of B-1 columns, and the
/// output is the sum of B. Registers: P x Count x (B-1) partial sums and P x Count window costs.
template <const StereoConfig& C, int Count>
struct WindowSum {
   static constexpr int kClocks = 1;
   static constexpr int kPixels = C.pixels_per_clock;
   static constexpr int kPartials = C.window_px - 1;
   using Sum = WindowCost<C>;

   Sum partial[kPixels][kPartials][Count];  ///< [p][j]: the last j+1 column costs
   CentreTag<C> centre;
   Sum sum[kPixels][Count];  ///< S(x,y,d)
   PixelTag tag;             ///< of the window's centre

   template <class Source, int Number>
   HLS_INLINE WindowSum(Source&, MemoryId<Number>) {
      HLS_UNROLL
      for (int p = 0; p < kPixels; ++p) {
         HLS_UNROLL
         for (int j = 0; j < kPartials; ++j) fill<Sum>(partial[p][j], 0);
         fill<Sum>(sum[p], 0);
      }
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
template <const StereoConfig& C, int Count>
struct RunningWindowSum {
   static constexpr int kClocks = 3;
   static constexpr int kPixels = C.pixels_per_clock;
   static constexpr int kCostBits = bits_for(C.largest_column_cost());
   using Pack = Packed<kCostBits, kPixels * Count>;
   using Word = typename Pack::Word;
   using Sum = WindowCost<C>;

   Ring<Word, C.window_px + 1, Pack::kWords> ring;
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
      fill<Word>(leaving, 0);
      HLS_UNROLL
      for (int p = 0; p < kPixels; ++p) {
         fill<ColumnCost<C>>(entering[p], 0);
         fill<int32_t>(change[p], 0);
         fill<Sum>(sum[p], 0);
      }
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
template <const StereoConfig& C, int Count>
using WindowBlock =
    std::conditional_t<C.aggregation == Aggregation::recursive, RunningWindowSum<C, Count>, WindowSum<C, Count>>;

}  // namespace stereo
