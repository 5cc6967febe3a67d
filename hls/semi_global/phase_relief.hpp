// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "semi_global/phase_costs.hpp"
#include "semi_global/relief.hpp"
#include "support/memory_bank.hpp"

namespace stereo::semi_global {

/// What a fresh start costs in each column of the paths along a row where P2 falls, with several clocks a pixel pair:
/// f of docs/algorithm.md (S2), with the bias of K. The path from the right gets those of the row before, turned
/// round. Memory: that of the columns; with a path from the right map width x bits of a relief, and one place more.
template <const Config& C>
struct PhaseRelief : ReliefColumns<C> {
   using Columns = ReliefColumns<C>;
   using At = Stages<C>;
   static constexpr int kPhases = At::kPhases;
   static constexpr int kWidth = C.output_width_px();
   static constexpr uint16_t kNoPlace = kWidth;
   using Value = Relief<C>;
   using Start = RowPathValue<C>;
   static constexpr int kBias = C.row_path_bias();
   using TurnMemory = Optional<C.path_right, MemoryBank<Value, kWidth + 1, 1>>;
   static constexpr int kMemories = Columns::kMemories + TurnMemory::kMemories;
   /// The stage of the column that ColumnLine has newest, and the first one at which a fresh start is known.
   static constexpr int kNewest = 1 - PhaseCosts<C>::kClocks;
   static constexpr int kFirst = kNewest + 2;
   static constexpr int kPlaces = (At::kPaths - 1 - kFirst) / kPhases + 1;

   Value entering;  // kNewest
   [[no_unique_address]] ReliefLimit<C> limit;
   Value entered;  // kNewest + 1
   TurnMemory turn_memory;
   Value turned[1];      ///< of the row before; the path from the right meets it a column later
   Start left[kPlaces];  ///< [j]: from stage kFirst + j * kPhases on
   Start right[kPlaces];
   Value between;  ///< the column of the row before that came last and the next one
   Value write_turned[1];
   uint16_t write_address;

   template <class Source, int First>
   HLS_INLINE PhaseRelief(Source& memories, MemoryId<First> first)
       : Columns(memories, first), turn_memory(memories, MemoryId<First + Columns::kMemories>()) {
      start(*this);
   }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      Columns::registers(visit);
      visit("entering", entering);
      if constexpr (C.run_time_settings) visit("largest", limit.largest.value, C.largest_relief());
      visit("entered", entered);
      if constexpr (C.path_left) visit("left", left);
      if constexpr (C.path_right) {
         visit("turned", turned);
         visit("right", right);
         visit("between", between);
         visit("write_turned", write_turned);
         visit("write_address", write_address);
      }
   }

   /// Of the column whose phase 0 is at that stage in this clock.
   template <bool Turned, int Stage>
   HLS_INLINE Start at() const {
      static_assert(Stage >= kFirst && Stage < At::kPaths);
      constexpr int kPlace = (Stage - kFirst) / kPhases;
      if constexpr (Turned) return right[kPlace];
      else return left[kPlace];
   }

   /// Before the clocks of the blocks that it goes beside: it reads what they held until now.
   template <class Line, class LineRows, class PairDelayed, class Places, class Settings>
   HLS_INLINE void clock(const Line& line, const LineRows& column_rows, const PairDelayed& pairs, const Places& raster,
                         const Settings& settings) {
      const bool first = line.newest.first_column;
      if constexpr (C.path_left) pass_on(line, left, entered, first);
      if constexpr (C.path_right) {
         pass_on(line, right, between, first);
         turn(line);
      }
      entered = limit.limited(entering);
      limit.take(line.template is_there<kNewest>() & first & line.newest.top, settings);
      entering = select<Value>(column_rows.tag.valid, Columns::of_centre(), entering);
      Columns::follow(column_rows, pairs, raster);
   }

  private:
   template <class Line>
   static HLS_INLINE void pass_on(const Line& line, Start (&falls)[kPlaces], Value relief, bool first) {
      pass_older<kPlaces - 1>(line, falls);
      const Start here = select<Start>(first, kBias, Start(kBias - relief));
      falls[0] = select<Start>(line.template is_there<kNewest + 1>(), here, falls[0]);
   }
   template <int Place, class Line>
   static HLS_INLINE void pass_older(const Line& line, Start (&falls)[kPlaces]) {
      if constexpr (Place > 0) {
         constexpr int kStage = kNewest + 1 + Place * kPhases;
         falls[Place] = select<Start>(line.template is_there<kStage>(), falls[Place - 1], falls[Place]);
         pass_older<Place - 1>(line, falls);
      }
   }

   /// A column of the row before is read at the place that this row's column takes.
   template <class Line>
   HLS_INLINE void turn(const Line& line) {
      Value stored[1];
      turn_memory.read(line.order.address, stored);
      turn_memory.write(write_address, write_turned);
      write_turned[0] = entered;
      write_address = select<uint16_t>(line.template starts<kNewest + 1>(), line.order.address, kNoPlace);
      between = select<Value>(line.template is_there<kNewest + 1>(), turned[0], between);
      turned[0] = stored[0];
   }
};

/// The cheapest fresh start of the last look_back columns, this one included: F of docs/algorithm.md (S2), found as the
/// smallest of pairs, fours and two or three fours that may overlap.
template <const Config& C>
struct CheapestStart {
   using Start = RowPathValue<C>;
   static constexpr int kLookBack = C.look_back_columns();
   static constexpr bool kIsLong = kLookBack > 8;
   static constexpr int kClocks = kIsLong ? 5 : 4;
   static_assert(kLookBack >= 7 && kLookBack <= 12, "two or three fours cover them");

   Start newest[2], pairs[3], fours[kLookBack - 3];  ///< [j]: of the column j columns before, and of those before it
   Start eight, oldest;                              ///< of the newest and of the oldest columns
   Start cheapest;

   HLS_INLINE CheapestStart() { start(*this); }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("newest", newest);
      visit("pairs", pairs);
      visit("fours", fours);
      if constexpr (kIsLong) {
         visit("eight", eight);
         visit("oldest", oldest);
      }
      visit("cheapest", cheapest);
   }

   /// here: the fresh start of the column at `Stage`. Its column's `cheapest` is there kClocks later.
   template <int Stage, class Line>
   HLS_INLINE void clock(const Line& line, Start here) {
      if constexpr (kIsLong) {
         cheapest = smaller_of<Start>(eight, oldest);
         eight = smaller_of<Start>(fours[0], fours[4]);
         oldest = fours[kLookBack - 4];
      } else {
         cheapest = smaller_of<Start>(fours[0], fours[kLookBack - 4]);
      }
      move(line.template starts<Stage + 2>(), fours, smaller_of<Start>(pairs[0], pairs[2]));
      move(line.template starts<Stage + 1>(), pairs, smaller_of<Start>(newest[0], newest[1]));
      move(line.template starts<Stage>(), newest, here);
   }

  private:
   template <int Count>
   static HLS_INLINE void move(bool now, Start (&held)[Count], Start in) {
      HLS_UNROLL
      for (int j = Count - 1; j > 0; --j) held[j] = select<Start>(now, held[j - 1], held[j]);
      held[0] = select<Start>(now, in, held[0]);
   }
};

/// What a row path of several clocks a pixel pair knows of a P2 that falls.
template <const Config& C>
struct PhaseStarts {
   using Start = RowPathValue<C>;
   CheapestStart<C> past;
   Start known;  ///< the better one of the best path of then and the cheapest fresh start since then
   Start here;   ///< of the column whose costs are there

   HLS_INLINE PhaseStarts() { start(*this); }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("past", past);
      visit("known", known);
      visit("here", here);
   }
};

}  // namespace stereo::semi_global
