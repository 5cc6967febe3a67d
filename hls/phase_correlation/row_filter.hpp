// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "phase_correlation/column_filter.hpp"

namespace stereo::phase_correlation {

/// The filters of one scale along the rows, from what the filters along the columns give: boxes of kStep columns, then
/// the even and the odd filter of five of them, and the signs of the six parts of the complex responses. kClocks
/// clocks, as many for every scale. The pixel of the signs is the last one that has all columns of its filters.
///
/// Numbers are modulo 2^kBits, which holds the largest response and its sign. They are kept negated: the highest bit
/// says that the response is above 0.
template <const auto& C, int Scale>
struct RowFilter {
   static constexpr int kStep = 1 << Scale;
   static constexpr int kBoxClocks = C.scales - 1;
   static constexpr int kClocks = kBoxClocks + 3;
   static constexpr int kBits = C.pixel_bits + 6 + 2 * Scale;
   static_assert(1 << (kBits - 1) > 26 * C.largest_pixel() * kStep * kStep, "the largest sum of two products");
   static constexpr int kColumns = 4 * kStep;
   static constexpr int kLag = kStep > 1 ? kStep / 2 : 1;
   using Value = uint_of_bits<kBits>;
   using AlongColumn = typename ColumnFilter<C, Scale>::Value;
   static constexpr Value kMask = Value((uint64_t(1) << kBits) - 1);

   Value earlier[kBoxClocks > 0 ? kBoxClocks : 1][kFilters][kLag];  ///< [clock][filter][columns before]
   Value box[kBoxClocks > 0 ? kBoxClocks : 1][kFilters];
   Value column[kFilters][kColumns];         ///< boxes, the newest first
   Value centre[kFilters], outer[kFilters];  ///< box 0, boxes -2 and 2
   Value before[kFilters], after[kFilters];  ///< boxes -2 and -1, 2 and 1, the nearer one twice
   Value even[kFilters], odd[kFilters];      ///< negated
   uint8_t signs;                            ///< bits 0 ... 5 of the scale's code

   HLS_INLINE RowFilter() { start(*this); }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("earlier", earlier);
      visit("box", box);
      visit("column", column);
      visit("centre", centre);
      visit("outer", outer);
      visit("before", before);
      visit("after", after);
      visit("even", even);
      visit("odd", odd);
      visit("signs", signs);
   }

   /// tags[j].valid: what the boxes take in their clock j, and behind the last box the taps, are pixels.
   template <class Tag>
   HLS_INLINE void clock(const AlongColumn (&response)[kFilters], const Tag* tags) {
      find_signs();
      HLS_UNROLL
      for (int f = 0; f < kFilters; ++f) {
         even[f] = Value(outer[f] - 2 * centre[f]) & kMask;
         odd[f] = (C.reference == Reference::right ? Value(before[f] - after[f]) : Value(after[f] - before[f])) & kMask;
      }
      take_taps(response, tags[kBoxClocks].valid);
      if constexpr (kBoxClocks > 0) add_boxes<kBoxClocks - 1>(response, tags);
   }

  private:
   static HLS_INLINE uint8_t above_0(Value negated) { return uint8_t(negated >> (kBits - 1) & 1); }

   HLS_INLINE void find_signs() {
      signs = uint8_t(above_0(even[0]) | above_0(odd[0]) << 1 | above_0(Value(even[1] - odd[2])) << 2 |
                      above_0(Value(odd[1] + even[2])) << 3 | above_0(Value(even[1] + odd[2])) << 4 |
                      above_0(Value(odd[1] - even[2])) << 5);
   }

   HLS_INLINE void take_taps(const AlongColumn (&response)[kFilters], bool move) {
      HLS_UNROLL
      for (int f = 0; f < kFilters; ++f) {
         Value newest;
         if constexpr (kBoxClocks > 0) newest = box[kBoxClocks - 1][f];
         else newest = response[f];
         centre[f] = column[f][2 * kStep - 1];
         outer[f] = Value(column[f][4 * kStep - 1] + newest) & kMask;
         before[f] = Value(column[f][4 * kStep - 1] + 2 * column[f][3 * kStep - 1]) & kMask;
         after[f] = Value(newest + 2 * column[f][kStep - 1]) & kMask;
         HLS_UNROLL
         for (int i = kColumns - 1; i > 0; --i) column[f][i] = select<Value>(move, column[f][i - 1], column[f][i]);
         column[f][0] = select<Value>(move, newest, column[f][0]);
      }
   }

   /// Clocks J, J-1, ... of the boxes; recursion as in ColumnFilter.
   template <int J, class Tag>
   HLS_INLINE void add_boxes(const AlongColumn (&response)[kFilters], const Tag* tags) {
      constexpr int kColumnsBefore = 1 << J;
      HLS_UNROLL
      for (int f = 0; f < kFilters; ++f) {
         Value in;
         if constexpr (J > 0) in = box[J - 1][f];
         else in = response[f];
         if constexpr (kColumnsBefore >= kStep) {
            box[J][f] = in;
         } else {
            box[J][f] = Value(in + earlier[J][f][kColumnsBefore - 1]) & kMask;
            HLS_UNROLL
            for (int i = kColumnsBefore - 1; i > 0; --i)
               earlier[J][f][i] = select<Value>(tags[J].valid, earlier[J][f][i - 1], earlier[J][f][i]);
            earlier[J][f][0] = select<Value>(tags[J].valid, in, earlier[J][f][0]);
         }
      }
      if constexpr (J > 0) add_boxes<J - 1>(response, tags);
   }
};

}  // namespace stereo::phase_correlation
