// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "semi_global/phase_relief.hpp"
#include "semi_global/phases.hpp"
#include "semi_global/settings.hpp"
#include "support/memory_bank.hpp"
#include "support/packed.hpp"

namespace stereo::semi_global {

/// A path along a row, a phase a clock: what RowPath is for all disparities at once, with the same numbers. K and A of
/// the column before stand in a ring with a word for each phase; the loop takes four clocks, and so no less than four
/// phases. Costs come at the stage kPaths, K is there at kPathCosts. Memory: phases x 2 x lanes x bits of K, LUT RAM.
/// K and A have no relief: the next column, whose relief RowPath adds, may come at any time. Turned: this is the path
/// from the right.
///
///    clock, of phase p   read it | K and A of the column before | the smaller ones, changes | K and A | written
template <const Config& C, bool Turned = false>
struct PhaseRowPath {
   using At = Stages<C>;
   static constexpr int kPhases = At::kPhases;
   static constexpr int kLanes = At::kLanes;
   static constexpr int kBits = C.row_path_bits();
   static constexpr int kBias = C.row_path_bias();
   static constexpr int kLookBack = C.look_back_columns();
   using Value = RowPathValue<C>;
   static constexpr Value kMask = Value((1 << kBits) - 1);
   using Start = uint_of_bits<bits_for(C.p2)>;
   static constexpr Start kStartMask = Start((uint64_t(1) << bits_for(C.p2)) - 1);
   using Pack = Packed<kBits, 2 * kLanes>;  ///< K of all lanes, then A
   using Word = typename Pack::Word;
   using States = MemoryBank<Word, kPhases, Pack::kWords>;
   using Neighbours = MemoryBank<Value, kPhases, 1>;
   static constexpr int kLowPlaces = 16;
   using Lows = MemoryBank<Value, kLowPlaces, 1>;
   static constexpr int kMemories = States::kMemories + Neighbours::kMemories + Lows::kMemories;
   using Tree = MinimumTree<Value, kLanes>;
   /// When the smallest K of a column is written, and when that of look_back columns before is read.
   static constexpr int kLow = At::kLow;
   static constexpr int kReadsLow = At::kPaths - 5 - (C.has_relief() ? 1 : 0);
   static_assert(kLookBack < kLowPlaces && kLow < kLookBack * kPhases + kReadsLow, "it must be there");
   /// When a column's fresh start comes to those that the definition looks back over.
   static constexpr int kLooksBack = kReadsLow + 1 - CheapestStart<C>::kClocks;
   /// The upper neighbour's phase comes a clock later, in the clock in which it is read ahead for the next column.
   static constexpr bool kPassesBy = kPhases == 4;

   States states;
   Neighbours neighbours;  ///< K of lane 0, read a phase ahead
   Lows lows;
   [[no_unique_address]] FirstPenalty<C> p1;
   [[no_unique_address]] SecondPenalty<C> p2;
   [[no_unique_address]] std::conditional_t<C.has_relief(), PhaseStarts<C>, NoSettings> fresh;
   // q; beside each step, how many clocks before the costs; the first two are a clock earlier where P2 falls
   uint16_t low_address;                   // 5
   Value lowest[1];                        // 4
   bool lost;                              // 3: the best path is no better than a fresh start
   bool short_of;                          ///< it is nearer to the fresh start than `room`
   Start missing, below;                   ///< by how much, and how far from it
   Start q, room_left;                     // 2; `room` less q
   Start q_now;                            // 1
   Value q_less;                           ///< less P1
   Start room, start_cost[kLookBack - 1];  ///< for the next column; [j]: q of j columns before
   bool first;                             // 0: the column is the first of its row
   Value g, g_less;
   // a clock before the costs
   PhaseCount<kPhases> read_count, ahead_count;  ///< the latter is at the phase behind, if there is one
   // beside the costs
   bool is_first, is_last;  ///< the phase
   Word read_words[Pack::kWords];
   Value read_neighbour[1];
   bool passes_by;
   Value passed_by;
   Value lower_neighbour;  ///< K of the last lane of the phase before
   // a clock behind them
   Value stay[kLanes], step[kLanes];
   Value stay_change[kLanes], step_change[kLanes];  ///< c - g, c - g + P1
   // 2 clocks behind them
   Value cost[kLanes], arrived[kLanes];  ///< K and A
   PhaseCount<kPhases> write_count;
   Tree tree;
   Value low[1];
   uint16_t low_write_address;

   template <class Source, int First>
   HLS_INLINE PhaseRowPath(Source& memories, MemoryId<First> number)
       : states(memories, number),
         neighbours(memories, MemoryId<First + States::kMemories>()),
         lows(memories, MemoryId<First + States::kMemories + Neighbours::kMemories>()) {
      start(*this);
   }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      if constexpr (C.run_time_settings) {
         visit("p1", p1.value, C.p1);
         visit("p2", p2.value, C.p2);
      }
      if constexpr (C.has_relief()) visit("fresh", fresh);
      visit("low_address", low_address, kLowPlaces - 1 - kLookBack);
      visit("lowest", lowest);
      visit("lost", lost);
      visit("short_of", short_of);
      visit("missing", missing);
      visit("below", below);
      visit("q", q);
      visit("room_left", room_left);
      visit("q_now", q_now);
      visit("q_less", q_less);
      visit("room", room);
      visit("start_cost", start_cost);
      visit("first", first);
      visit("g", g);
      visit("g_less", g_less);
      visit("read_count", read_count);
      visit("ahead_count", ahead_count);
      visit("is_first", is_first);
      visit("is_last", is_last, true);
      visit("read_words", read_words);
      visit("read_neighbour", read_neighbour);
      if constexpr (kPassesBy) visit("passes_by", passes_by);
      if constexpr (kPassesBy) visit("passed_by", passed_by);
      visit("lower_neighbour", lower_neighbour);
      visit("stay", stay);
      visit("step", step);
      visit("stay_change", stay_change);
      visit("step_change", step_change);
      visit("cost", cost);
      visit("arrived", arrived);
      visit("write_count", write_count);
      visit("tree", tree);
      visit("low", low);
      visit("low_write_address", low_write_address);
   }

   /// smallest_cost: of the column whose costs begin in the next clock.
   template <class Line, class Reliefs>
   HLS_INLINE void clock(const Line& line, PathCost<C> smallest_cost, const PathCost<C> (&costs)[kLanes],
                         [[maybe_unused]] const Reliefs& relief) {
      Word stored[Pack::kWords];
      Value neighbour[1];
      states.read(read_count.phase, stored);
      neighbours.read(ahead_count.phase, neighbour);
      Value low_read[1];
      lows.read(low_address, low_read);
      const bool passes = write_count.phase == ahead_count.phase;
      const Value passing = cost[0];
      write();
      keep_low(line);
      finish(line.template starts<At::kPaths + 1>());
      scan(costs);
      if constexpr (kPassesBy) {
         passes_by = passes;
         passed_by = passing;
      }
      lower_neighbour = Value(Pack::lane(read_words, kLanes - 1));
      HLS_UNROLL
      for (int w = 0; w < Pack::kWords; ++w) read_words[w] = stored[w];
      read_neighbour[0] = neighbour[0];
      is_first = read_count.is_first();
      is_last = read_count.is_last();
      read_count.clock(line.template starts<At::kPaths - 2>());
      ahead_count.clock(line.template starts<At::kPaths - 3>());

      const bool comes = line.template starts<At::kPaths - 1>();
      first = select<bool>(comes, line.template at<At::kPaths - 1>().first_column, first);
      g = select<Value>(comes, Value(smallest_cost + q_now) & kMask, g);
      g_less = select<Value>(comes, Value(smallest_cost + q_less) & kMask, g_less);
      find_start(line, low_read[0]);
      if constexpr (C.has_relief()) {
         fresh.here = select<Value>(comes, relief.template at<Turned, At::kPaths - 1>(), fresh.here);
         fresh.past.template clock<kLooksBack>(line, relief.template at<Turned, kLooksBack>());
      }
   }

   /// Behind clock().
   template <class Line, class Settings>
   HLS_INLINE void take(const Line& line, const Settings& settings) {
      const auto& place = line.template at<At::kPaths - 4>();
      const bool of_frame = Turned ? place.shown.start_of_frame : place.first_column & place.top;
      const bool now = line.template starts<At::kPaths - 4>() & of_frame;
      p1.take(now, settings.p1);
      p2.take(now, settings.p2);
   }

  private:
   HLS_INLINE void write() {
      typename Pack::Lane lanes[2 * kLanes];
      Word words[Pack::kWords];
      HLS_UNROLL
      for (int l = 0; l < kLanes; ++l) {
         lanes[l] = cost[l];
         lanes[kLanes + l] = arrived[l];
      }
      Pack::pack(lanes, words);
      states.write(write_count.phase, words);
      const Value lane_0[1] = {cost[0]};
      neighbours.write(write_count.phase, lane_0);
   }

   /// The smallest K of each column, in their order.
   template <class Line>
   HLS_INLINE void keep_low(const Line& line) {
      lows.write(low_write_address, low);
      low_write_address = select<uint16_t>(line.template starts<kLow>(), wrapped<kLowPlaces>(low_write_address + 1u),
                                           low_write_address);
      low[0] = smallest_so_far<kBits>(line.template is_there<At::kPathCosts + At::kLevels>(), tree.root(), low[0]);
      tree.clock(cost, AlwaysMoves());
   }

   HLS_INLINE void finish(bool starts) {
      const bool moves = write_count.moves(starts);
      HLS_UNROLL
      for (int l = 0; l < kLanes; ++l) {
         cost[l] = select<Value>(moves, Value(stay[l] + stay_change[l]) & kMask, cost[l]);
         arrived[l] = select<Value>(moves, Value(step[l] + step_change[l]) & kMask, arrived[l]);
      }
      write_count.clock(starts);
   }

   HLS_INLINE Value upper_neighbour() const {
      if constexpr (kPassesBy) return select<Value>(passes_by, passed_by, read_neighbour[0]);
      else return read_neighbour[0];
   }

   HLS_INLINE void scan(const PathCost<C> (&costs)[kLanes]) {
      HLS_UNROLL
      for (int l = 0; l < kLanes; ++l) {
         const Value k = Value(Pack::lane(read_words, l)), a = Value(Pack::lane(read_words, kLanes + l));
         const Value best = smaller_of<Value>(k, a);
         stay[l] = select<Value>(first | is_fresh(k, a, best), fresh_start(), best);
         const Value beside = smaller_of<Value>(lower(l), upper(l));
         step[l] = select<Value>(first, kBias, beside);
         stay_change[l] = Value(costs[l] - g) & kMask;
         step_change[l] = Value(costs[l] - g_less) & kMask;
      }
   }
   /// Where P2 falls, K and A meet the fresh start beside each other: the loop has no time for one after the other.
   HLS_INLINE bool is_fresh(Value k, Value a, Value best) const {
      if constexpr (C.has_relief()) return (k >= fresh.here) & (a >= fresh.here);
      else return best >= kBias;
   }
   HLS_INLINE Value fresh_start() const {
      if constexpr (C.has_relief()) return fresh.here;
      else return kBias;
   }
   /// K beside lane l; at an end of the disparity range that on the other side.
   HLS_INLINE Value lower(int l) const {
      if (l > 0) return Value(Pack::lane(read_words, l > 0 ? l - 1 : 0));
      return select<Value>(is_first, Value(Pack::lane(read_words, 1)), lower_neighbour);
   }
   HLS_INLINE Value upper(int l) const {
      if (l < kLanes - 1) return Value(Pack::lane(read_words, l < kLanes - 1 ? l + 1 : 0));
      return select<Value>(is_last, Value(Pack::lane(read_words, kLanes - 2)), upper_neighbour());
   }

   /// Until a column of this row is read, `room` is 0, and so is q.
   template <class Line>
   HLS_INLINE void find_start(const Line& line, Value low_read) {
      const Start room_now = room;
      const bool comes = line.template starts<At::kPaths - 2>();
      const bool starts_row = line.template at<At::kPaths - 2>().first_column;
      q_now = select<Start>(comes, q, q_now);
      q_less = select<Value>(comes, Value(q - p1.get()) & kMask, q_less);
      const Start room_after = Start((room_left + start_cost[kLookBack - 2]) & kStartMask);
      room = select<Start>(comes, select<Start>(starts_row, 0, room_after), room);
      HLS_UNROLL
      for (int j = kLookBack - 2; j > 0; --j)
         start_cost[j] = select<Start>(comes, select<Start>(starts_row, 0, start_cost[j - 1]), start_cost[j]);
      start_cost[0] = select<Start>(comes, q, start_cost[0]);

      const bool chooses = line.template starts<At::kPaths - 3>();
      const Start wanted = select<Start>(lost, room_now, select<Start>(short_of, missing, 0));
      const Start after_row_start = select<Start>(line.template at<At::kPaths - 3>().first_column, p2.get(), wanted);
      q = select<Start>(chooses, after_row_start, q);
      const Start rest = select<Start>(short_of, below, room_now);
      room_left = select<Start>(chooses, select<Start>(lost, 0, rest), room_left);

      Value best = lowest[0];
      if constexpr (C.has_relief()) {
         best = fresh.known;
         fresh.known = smaller_of<Value>(lowest[0], fresh.past.cheapest);
      }
      const uint32_t depth = uint32_t(best & (kBias - 1)), reached = uint32_t(room_now) + depth;
      lost = best >= kBias;
      short_of = reached >= uint32_t(kBias);
      missing = Start(reached - kBias) & kStartMask;
      below = Start(kBias - depth) & kStartMask;
      lowest[0] = low_read;
      const bool reads = line.template starts<kReadsLow - 1>();
      low_address = select<uint16_t>(reads, wrapped<kLowPlaces>(low_address + 1u), low_address);
   }
};

}  // namespace stereo::semi_global
