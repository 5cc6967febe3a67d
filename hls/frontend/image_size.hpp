// SPDX-License-Identifier: Apache-2.0
// What the blocks of a core compare the place in a frame with: constants, or registers where the size comes from ports.
#pragma once

#include <type_traits>

#include "support/full_width.hpp"
#include "support/raster_counter.hpp"

namespace stereo {

/// Whether ports say how large the images are, up to the size of the configuration.
template <const auto& C>
inline constexpr bool kRunTimeSize = [] {
   if constexpr (requires { C.run_time_size; }) return C.run_time_size;
   else return false;
}();

/// Columns of a stream of rows, from one on up to another one; or, where these go round the end of a row, those up to
/// the end and those from the next row's beginning on.
struct ColumnRange {
   uint16_t from, to;  ///< both are columns of the range
   bool goes_round;

   HLS_INLINE constexpr bool has(uint16_t column) const {
      const bool is_behind = column >= from, is_ahead = column <= to;
      return select<bool>(goes_round, is_behind | is_ahead, is_behind & is_ahead);
   }
};

/// With full_width the columns `first` ... `width` - `left_out` of the reference, which lags behind the image that
/// comes in by less than a row: the columns of the latter with which they come.
template <const auto& C>
HLS_INLINE constexpr ColumnRange reference_columns(int first, int left_out, int width) {
   constexpr int kDelay = C.reference_delay();
   const int from = first + kDelay;
   const bool starts_here = from < width;
   const bool ends_here = left_out > kDelay;
   const int to = ends_here ? width - left_out + kDelay : kDelay - left_out;
   return {uint16_t(starts_here ? from : from - width), uint16_t(to), starts_here && !ends_here};
}

/// All frames have the size of the configuration.
template <const auto& C>
struct FixedSize {
   static constexpr bool kFixed = true;
   static constexpr FixedRaster<C.width_px, C.row_groups(), C.delay_groups()> windows = {};
   static constexpr FixedRaster<C.output_width_px(), C.row_groups(), 1> map = {};
   static constexpr FixedRaster<C.width_px, C.row_groups(), C.transform_groups()> transform = {};
   static constexpr int last_map_column = C.first_map_column() + C.output_width_px() - 1;
   // With full_width: a column of the same row leaves the window that the column enters; the column is the centre of a
   // column of the map.
   static constexpr ColumnRange leaving_columns = reference_columns<C>(C.window_px, 1, C.width_px);
   static constexpr ColumnRange map_columns =
       reference_columns<C>(C.columns_before(), C.columns_after() + 1, C.width_px);
};

/// The reference's columns where the width comes from ports.
template <const auto& C, int First, int LeftOut>
struct RunTimeColumns : ColumnRange {
   static constexpr ColumnRange kLargest = reference_columns<C>(First, LeftOut, C.width_px);

   HLS_INLINE RunTimeColumns() { start(*this); }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("from", from, kLargest.from);
      visit("to", to, kLargest.to);
      visit("goes_round", goes_round, kLargest.goes_round);
   }

   HLS_INLINE void clock(uint16_t width) {
      const ColumnRange now = reference_columns<C>(First, LeftOut, width);
      from = at_most<C.width_px - 1>(now.from);
      to = at_most<C.width_px - 1>(now.to);
      goes_round = now.goes_round;
   }
};

/// What full_width needs of a size that ports show.
template <const auto& C>
struct FullWidthColumns {
   RunTimeColumns<C, C.window_px, 1> leaving_columns;
   RunTimeColumns<C, C.columns_before(), C.columns_after() + 1> map_columns;

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("leaving_columns", leaving_columns);
      visit("map_columns", map_columns);
   }

   HLS_INLINE void clock(uint16_t width) {
      leaving_columns.clock(width);
      map_columns.clock(width);
   }
};
struct NoFullWidthColumns {};

/// The size that the ports show. It may change only while the core is reset: from the clock after the reset on the
/// registers have what the port shows, which is what the core must see until the next reset.
template <const auto& C>
struct RunTimeSize : std::conditional_t<kFullWidth<C>, FullWidthColumns<C>, NoFullWidthColumns> {
   static constexpr bool kFixed = false;
   static constexpr int kColumnsLeftOut = C.width_px - C.output_width_px();
   static constexpr bool kHasMap = [] {
      if constexpr (requires { C.has_post_processing(); }) return C.median || C.has_post_processing();
      else return C.median;
   }();

   RunTimeRaster<C.width_px, C.row_groups(), C.delay_groups()> windows;
   RunTimeRaster<C.output_width_px(), C.row_groups(), 1> map;
   RunTimeRaster<C.width_px, C.row_groups(), C.transform_groups()> transform;
   uint16_t last_map_column;  ///< without full_width

   HLS_INLINE RunTimeSize() { start(*this); }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("windows", windows);
      if constexpr (kHasMap) visit("map", map);
      if constexpr (C.has_transform()) visit("transform", transform);
      if constexpr (kFullWidth<C>) {
         FullWidthColumns<C>::registers(visit);
      } else {
         visit("last_map_column", last_map_column, C.first_map_column() + C.output_width_px() - 1);
      }
   }

   HLS_INLINE void clock(uint16_t width, uint16_t height) {
      const uint16_t row_groups = uint16_t(height / unsigned(C.pixels_per_clock));
      windows.clock(width, row_groups);
      if constexpr (kHasMap) map.clock(uint16_t(width - unsigned(kColumnsLeftOut)), row_groups);
      if constexpr (C.has_transform()) transform.clock(width, row_groups);
      if constexpr (kFullWidth<C>) {
         FullWidthColumns<C>::clock(width);
      } else {
         constexpr int kBehind = kColumnsLeftOut - C.first_map_column() + 1;
         last_map_column = at_most<C.width_px - 1>(unsigned(int(width) - kBehind));
      }
   }
};

/// A number that falls with the width of the images from `Largest` on. After a new size it is right a clock later than
/// that.
template <const auto& C, int Largest>
struct RunTimeNumber {
   uint16_t value;

   HLS_INLINE RunTimeNumber() { start(*this); }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("value", value, Largest);
   }

   HLS_INLINE int get() const { return value; }
   template <class Size>
   HLS_INLINE void clock(const Size& size) {
      value = at_most<Largest>(unsigned(int(size.windows.last_column) + (Largest + 1 - C.width_px)));
   }
};

/// The same where all images have one width.
template <int Number>
struct FixedNumber {
   template <class Visitor>
   HLS_INLINE void registers(Visitor&) {}

   static HLS_INLINE constexpr int get() { return Number; }
   template <class Size>
   HLS_INLINE void clock(const Size&) {}
};

/// What is `Largest` with images as wide as the configuration's.
template <const auto& C, int Largest>
struct OfWidth {
   using Type = std::conditional_t<kRunTimeSize<C>, RunTimeNumber<C, Largest>, FixedNumber<Largest>>;
};

/// Whether a group that is counted is not behind another one, which is the group `last` where the images have the
/// configuration's size, and as far from their lower border where they do not.
template <const auto& C, class Raster>
HLS_INLINE bool is_until(uint16_t group, int last, const Raster& raster) {
   return int16_t(group - raster.groups) <= last - C.row_groups();
}

}  // namespace stereo
