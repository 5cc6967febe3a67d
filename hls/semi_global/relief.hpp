// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "frontend/transform.hpp"
#include "semi_global/config.hpp"
#include "semi_global/cost_slice.hpp"
#include "semi_global/settings.hpp"
#include "support/optional_block.hpp"
#include "support/ring.hpp"
#include "support/row_buffer.hpp"

namespace stereo::semi_global {

/// Grey values of the reference beside what the transform makes of them, for a core whose cost has one.
template <const Config& C>
struct CentreGrey {
   using Filter = typename Transform<kWindowConfig<C>>::Filter;
   static constexpr int kColumns = kWindowConfig<C>.transform_columns();

   static constexpr int kClocks = Filter::kClocks - 1;

   Pixel<C> column[kColumns + 1];  ///< [age]: beside the columns in the filter's clock 1
   Pixel<C> grey[kClocks];         ///< [j]: of the centre, beside what the filter makes in its clock j+2

   HLS_INLINE CentreGrey() { start(*this); }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("column", column);
      visit("grey", grey);
   }

   HLS_INLINE Pixel<C> output() const { return grey[kClocks - 1]; }

   /// Before the transform's own clock.
   HLS_INLINE void clock(const Transform<kWindowConfig<C>>& transform) {
      constexpr int kCentre = kWindowConfig<C>.transform_rows();
      const Pixel<C> newest =
          C.reference == Reference::right ? transform.right_column[kCentre] : transform.left_column[kCentre];
      HLS_UNROLL
      for (int j = kClocks - 1; j > 0; --j) grey[j] = grey[j - 1];
      grey[0] = column[kColumns];
      HLS_UNROLL
      for (int age = kColumns; age > 0; --age)
         column[age] = select<Pixel<C>>(transform.columns.valid, column[age - 1], column[age]);
      column[0] = select<Pixel<C>>(transform.columns.valid, newest, column[0]);
   }
};

/// The relief beside the columns of the windows' rows: by how much P2 falls between the column before and this one. It
/// follows the reference's pixels beside the blocks that make columns of them. Memory: (delay_groups() x W + the
/// reference's delay) x bits of a relief.
template <const Config& C>
struct ReliefColumns {
   static constexpr const auto& kWindows = kWindowConfig<C>;
   static constexpr int kBits = C.relief_bits();
   static constexpr int kLargest = C.largest_relief();
   static constexpr int kShift = C.relief_shift();
   static constexpr int kDelay = kWindows.reference_delay();
   static constexpr int kRows = kWindows.delay_groups();
   static constexpr int kColumns = kWindows.columns_after();  ///< by which a window's centre is older than its newest
   using Value = Relief<C>;
   using Delay = Ring<Value, kDelay + 1, (kDelay > 0 ? 1 : 0)>;
   using Rows = Optional<(kRows > 0), RowBuffer<kBits, 1, kRows, C.width_px>>;
   /// Clocks of the line buffer; where no row is held back, the relief waits as many.
   static constexpr int kRowClocks = kWindows.window_px == 1 ? 1 : 3;
   static constexpr int kShown = kRows > 0 ? 1 : kRowClocks;
   static constexpr int kOlder = kColumns > 0 ? kColumns : 1;
   using Centre = std::conditional_t<kWindows.has_transform(), CentreGrey<C>, NoSettings>;
   static constexpr int kMemories = Delay::kMemories + Rows::kMemories;

   [[no_unique_address]] Centre centre;
   Pixel<C> before;  ///< grey value of the last pixel
   Value newest;     ///< beside the raster's features
   Delay delay;
   Value delayed[1];      ///< beside the pair delay
   Rows rows;             // beside the line buffer's clocks 1 and 2
   Value shown[kShown];   ///< [kShown - 1]: beside its columns
   Value column[kOlder];  ///< [age]: of the windows' columns before the newest

   template <class Source, int First>
   HLS_INLINE ReliefColumns(Source& memories, MemoryId<First> first)
       : delay(memories, first), rows(memories, MemoryId<First + Delay::kMemories>()) {}

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      if constexpr (kWindows.has_transform()) visit("centre", centre);
      visit("before", before);
      visit("newest", newest);
      if constexpr (kDelay > 0) visit("delay", delay);
      visit("delayed", delayed);
      if constexpr (kRows > 0) visit("rows", rows);
      visit("shown", shown);
      if constexpr (kColumns > 0) visit("column", column);
   }

   /// Of the centre of the windows that the line buffer's columns complete.
   HLS_INLINE Value of_centre() const { return kColumns > 0 ? column[kOlder - 1] : shown[kShown - 1]; }

   /// Before the clocks of the blocks that it goes beside: it reads what they held until now.
   template <class LineRows, class PairDelayed, class Places>
   HLS_INLINE void follow(const LineRows& line, const PairDelayed& pairs, const Places& raster) {
      take_column(line.tag.valid);
      follow_rows(line, pairs);
      Value oldest[1] = {newest};
      if constexpr (kDelay > 0) {
         const Value now[1] = {newest};
         delay.clock(now, raster.features.valid, oldest);
      }
      delayed[0] = oldest[0];
   }

   /// The pixel that comes to the raster, before the raster's own clock.
   HLS_INLINE void compare(const CoreInput<C>& in) {
      if constexpr (!kWindows.has_transform()) {
         compare(C.reference == Reference::right ? in.right[0] : in.left[0], in.valid);
      }
   }
   /// The same from a transform, before its clock.
   HLS_INLINE void compare(const Transform<kWindowConfig<C>>& transform) {
      constexpr int kLast = Transform<kWindowConfig<C>>::Filter::kClocks - 1;
      compare(centre.output(), transform.filtering[kLast].valid);
      centre.clock(transform);
   }

  private:
   HLS_INLINE void compare(Pixel<C> grey, bool valid) {
      const Pixel<C> difference = select<Pixel<C>>(grey > before, Pixel<C>(grey - before), Pixel<C>(before - grey));
      const Pixel<C> fall = Pixel<C>(difference >> kShift);
      newest = Value(at_most<kLargest>(select<int>(fall > kLargest, kLargest, fall)));
      before = select<Pixel<C>>(valid, grey, before);
   }

   HLS_INLINE void take_column(bool move) {
      HLS_UNROLL
      for (int age = kOlder - 1; age > 0; --age) column[age] = select<Value>(move, column[age - 1], column[age]);
      column[0] = select<Value>(move, shown[kShown - 1], column[0]);
   }

   template <class LineRows, class PairDelayed>
   HLS_INLINE void follow_rows(const LineRows& line, const PairDelayed& pairs) {
      if constexpr (kRows > 0) {
         shown[0] = rows.row(0);
         rows.clock(delayed, pairs.column, line.ready.tag.valid, line.write_column);
      } else {
         HLS_UNROLL
         for (int j = kShown - 1; j > 0; --j) shown[j] = shown[j - 1];
         shown[0] = delayed[0];
      }
   }
};

/// The largest relief of a frame, where its settings come from ports.
template <const Config& C>
struct ReliefLimit {
   using Value = Relief<C>;
   static constexpr int kLargest = C.largest_relief();

   [[no_unique_address]] NumberHere<C.run_time_settings, kLargest> largest;

   HLS_INLINE Value limited(Value relief) const {
      const int fall = relief;
      return Value(at_most<kLargest>(select<int>(fall > largest.get(), largest.get(), fall)));
   }
   template <class Settings>
   HLS_INLINE void take(bool of_frame, const Settings& settings) {
      if constexpr (C.run_time_settings) {
         const uint16_t least = settings.p2_least, most = settings.p2;
         largest.take(of_frame, select<uint16_t>(most > least, at_most<kLargest>(uint16_t(most - least)), 0));
      }
   }
};

/// The relief of the columns that come to the paths, where these take a column a move.
template <const Config& C>
struct ReliefStream : ReliefColumns<C> {
   using Columns = ReliefColumns<C>;
   using Value = Relief<C>;
   static constexpr int kSliceClocks = CostSlice<C>::kClocks;

   Value waiting[kSliceClocks];  ///< [kSliceClocks - 1]: beside the slices' costs
   [[no_unique_address]] ReliefLimit<C> limit;
   Value entering;  ///< beside the entry's clock 1
   Value entered;   ///< beside its costs

   template <class Source, int First>
   HLS_INLINE ReliefStream(Source& memories, MemoryId<First> first) : Columns(memories, first) {
      start(*this);
   }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      Columns::registers(visit);
      visit("waiting", waiting);
      if constexpr (C.run_time_settings) visit("largest", limit.largest.value, C.largest_relief());
      visit("entering", entering);
      visit("entered", entered);
   }

   /// Before the clocks of the blocks that it goes beside.
   template <class LineRows, class PairDelayed, class Places, class Settings>
   HLS_INLINE void clock(const PixelTag& slices_tag, const LineRows& line, const PairDelayed& pairs,
                         const Places& raster, const Settings& settings) {
      entered = entering;
      entering = limit.limited(waiting[kSliceClocks - 1]);
      limit.take(slices_tag.valid & slices_tag.start_of_frame, settings);
      HLS_UNROLL
      for (int j = kSliceClocks - 1; j > 0; --j) waiting[j] = waiting[j - 1];
      waiting[0] = Columns::of_centre();
      Columns::follow(line, pairs, raster);
   }
};

}  // namespace stereo::semi_global
