// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cost/centre_tag.hpp"
#include "frontend/image_size.hpp"
#include "frontend/pixel_tag.hpp"
#include "semi_global/map_place.hpp"
#include "semi_global/phases.hpp"
#include "semi_global/row_order.hpp"

namespace stereo::semi_global {

/// Where a column is in the map, and where the row is turned round.
struct ColumnPlace {
   bool map_column;
   bool first_column;  ///< of its row
   bool top;           ///< the row is the first of a frame, if this column is the first one
   uint16_t address;   ///< in the memories that turn rows round
   MapPlace shown;     ///< of the column whose sums are made beside it: of this row, or turned of the row before

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("map_column", map_column);
      visit("first_column", first_column);
      visit("top", top);
      visit("address", address);
      visit("shown", shown);
   }
};

/// The columns on their way beside their phases. Phases wait for nothing, so a column is at each stage a fixed number
/// of clocks behind its pixel pair: a flag moves on each clock, and what is known of the column once in all phases,
/// which is often enough, as the next one is that far behind. First: the stage of the first flag, a clock behind the
/// pair.
template <const Config& C, int First>
struct ColumnLine {
   static constexpr int kPhases = Stages<C>::kPhases;
   static constexpr int kFlags = Stages<C>::kEnd - First;
   static constexpr int kPlaces = (kFlags + kPhases - 1) / kPhases;
   static constexpr int kWidth = C.output_width_px();

   CentreTag<kWindowConfig<C>> centre;
   RowOrder<kWidth, typename OfWidth<C, kWidth - 1>::Type> order;
   ColumnPlace newest;
   bool comes[kFlags];           ///< [j]: a column's phase 0 is at stage First + j, of the map or not
   bool starts_phases[kFlags];   ///< [j]: it is of the map; from j = 1 on
   ColumnPlace places[kPlaces];  ///< [j]: from stage First + j * kPhases + 1 on

   HLS_INLINE ColumnLine() { start(*this); }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("centre", centre);
      if constexpr (C.path_right) visit("order", order);
      visit("newest", newest);
      visit("comes", comes);
      visit("starts_phases", starts_phases);
      visit("places", places);
   }

   /// Of the column whose phase 0 is at that stage in this clock.
   template <int Stage>
   HLS_INLINE const ColumnPlace& at() const {
      static_assert(Stage > First && Stage - First < kFlags);
      return places[(Stage - First - 1) / kPhases];
   }
   template <int Stage>
   HLS_INLINE bool is_there() const {
      return comes[Stage - First];
   }
   /// Whether a column of the map is there. A register, as many choices depend on it.
   template <int Stage>
   HLS_INLINE bool starts() const {
      static_assert(Stage > First && Stage - First < kFlags);
      return starts_phases[Stage - First];
   }

   template <class Size>
   HLS_INLINE void clock(const PixelTag& newest_tag, [[maybe_unused]] const Size& size) {
      HLS_UNROLL
      for (int j = kPlaces - 1; j > 0; --j) take(places[j], places[j - 1], comes[j * kPhases]);
      ColumnPlace entered = newest;
      if constexpr (C.path_right) {
         entered.address = order.address;
         show(entered.shown, order.turned, true);
      }
      take(places[0], entered, comes[0]);
      HLS_UNROLL
      for (int j = kFlags - 1; j > 0; --j)
         starts_phases[j] = j == 1 ? comes[0] & newest.map_column : starts_phases[j - 1];
      HLS_UNROLL
      for (int j = kFlags - 1; j > 0; --j) comes[j] = comes[j - 1];

      const PixelTag in = centre.clock(newest_tag);
      comes[0] = in.valid;
      newest.map_column = select<bool>(in.valid, in.map_column, newest.map_column);
      newest.first_column = select<bool>(in.valid, in.first_column, newest.first_column);
      newest.top = select<bool>(in.valid, in.start_of_frame, newest.top);
      if constexpr (C.path_right) order.clock(in, size);
      else show(newest.shown, in, in.valid);
   }

  private:
   template <class Place>
   static HLS_INLINE void show(MapPlace& to, const Place& from, bool move) {
      to.map_column = select<bool>(move, from.map_column, to.map_column);
      to.output_column = select<bool>(move, from.output_column, to.output_column);
      to.first_column = select<bool>(move, from.first_column, to.first_column);
      to.start_of_frame = select<bool>(move, from.start_of_frame, to.start_of_frame);
      to.end_of_line = select<bool>(move, from.end_of_line, to.end_of_line);
   }
   static HLS_INLINE void take(ColumnPlace& to, const ColumnPlace& from, bool move) {
      to.map_column = select<bool>(move, from.map_column, to.map_column);
      to.first_column = select<bool>(move, from.first_column, to.first_column);
      to.top = select<bool>(move, from.top, to.top);
      to.address = select<uint16_t>(move, from.address, to.address);
      show(to.shown, from.shown, move);
   }
};

}  // namespace stereo::semi_global
