// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "block_matching/folding.hpp"
#include "block_matching/row_winners.hpp"
#include "cost/costs.hpp"
#include "support/memory_bank.hpp"
#include "support/packed.hpp"
#include "support/settings.hpp"
#include "winner/candidate.hpp"
#include "winner/winners.hpp"

namespace stereo::block_matching {

/// The left/right check of a row whose winners are known: those of the other image's pixels are kept for a row, best so
/// far from pass to pass, and a winner asks for that of the pixel that it points at. 3 clocks. Memory: 3 x the next
/// power of two from W on x a disparity, and once a cost.
///
/// Places in it are columns of the other image from the first one on that has a candidate. A pass shows each pixel when
/// it has met its last disparity there; those at an end of the row have met fewer, or none in the passes before.
template <const auto& C>
struct RowCheck {
   using Rows = TwoRows<C>;
   using Value = WindowCost<C>;
   using Best = Candidate<CandidateKind{.largest_cost = C.largest_window_cost(), .ties = C.ties}>;
   static constexpr bool kFalls = C.reference == Reference::right;
   static constexpr int kClocks = 3;
   static constexpr int kClocksToKeep = 4;  ///< of another image's pixel: 2 ... 5 below
   static_assert(kClocksToKeep == C.kColumnsToOther,
                 "Config counts the clocks in which a pass's pixels come into memory");
   static constexpr int kPasses = C.clocks_per_pixel;
   static constexpr int kLanes = C.pass_disparities();
   static constexpr int kShown = C.output_width_px() + kLanes - 1;  ///< pixels that a pass shows
   static constexpr int kDisparityBits = bits_for(C.disparities - 1);
   static constexpr int kCostBits = bits_for(C.largest_window_cost());
   static constexpr int kLaneBits = kCostBits > kDisparityBits ? kCostBits : kDisparityBits;
   using Pack = Packed<kLaneBits, 2>;
   using Word = typename Pack::Word;
   using Lane = typename Pack::Lane;
   using Memory = MemoryBank<Word, Rows::kColumns, Pack::kWords>;
   static constexpr uint16_t kNoPlace = Rows::kColumns - 1;
   using Winner = uint_of_bits<kDisparityBits>;
   using WinnerMemory = MemoryBank<Winner, Rows::kPlaces, 1>;
   static constexpr int kMemories = Memory::kMemories + WinnerMemory::kMemories;

   /// The other image's pixel that leaves the lanes.
   struct Shown {
      Value cost;
      uint8_t winner;
      uint16_t place;
      bool counts;      ///< it has met a disparity
      bool has_before;  ///< and one in the passes before
      bool row;         ///< of the two

      template <class Visitor>
      HLS_INLINE void registers(Visitor& visit) {
         visit("cost", cost);
         visit("winner", winner);
         visit("place", place);
         visit("counts", counts);
         visit("has_before", has_before);
         visit("row", row, 1);
      }
   };

   Memory best_so_far;
   WinnerMemory others;
   // the other image's pixels. Clock 1
   PixelTag tag;
   // clock 2
   Shown read;
   uint16_t pass;
   uint8_t base;      ///< the lowest disparity of the pass
   uint16_t first;    ///< the pass's first place
   uint16_t columns;  ///< of the pass before this one, up to all that count
   // clock 3
   Shown waiting;
   Word read_words[Pack::kWords];
   // clock 4
   Shown ready;
   Word ready_words[Pack::kWords];
   // clock 5
   Value cost;
   uint8_t winner;
   uint16_t write_place, write_address;
   // the winners. Clock 1
   Winners<C> asking;
   uint16_t address;
   // clock 2
   Winner found[1];
   Winners<C> answered;
   [[no_unique_address]] TakenOver<C, uint8_t> threshold;
   // clock 3
   Winners<C> checked;

   template <class Source, int First>
   HLS_INLINE RowCheck(Source& memories, MemoryId<First> first_memory)
       : best_so_far(memories, first_memory), others(memories, MemoryId<First + Memory::kMemories>()) {
      start(*this);
   }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("tag", tag);
      visit("read", read);
      visit("pass", pass, kPasses - 1);
      visit("base", base);
      visit("first", first);
      visit("columns", columns);
      visit("waiting", waiting);
      visit("read_words", read_words);
      visit("ready", ready);
      visit("ready_words", ready_words);
      visit("cost", cost);
      visit("winner", winner);
      visit("write_place", write_place);
      visit("write_address", write_address);
      visit("asking", asking);
      visit("address", address);
      visit("found", found);
      visit("answered", answered);
      if constexpr (kSetAtRunTime<C>) visit("threshold", threshold.value, C.left_right_threshold);
      visit("checked", checked);
   }

   /// last: the last slice of the lanes. in: the winners of a row that has had all passes.
   template <class Slice, class Settings = NoSettings>
   HLS_INLINE void clock(const Slice& last, const RowWinners<C>& in, const Settings& settings = Settings()) {
      Word found_words[Pack::kWords], kept[Pack::kWords];
      const Lane lanes[2] = {Lane(cost), Lane(winner)};
      const Winner kept_winner[1] = {Winner(winner)};
      Pack::pack(lanes, kept);
      best_so_far.read(read.place, found_words);
      best_so_far.write(write_place, kept);
      answer(settings);
      others.read(address, found);
      others.write(write_address, kept_winner);
      ask(in);
      join();
      HLS_UNROLL
      for (int w = 0; w < Pack::kWords; ++w) {
         ready_words[w] = read_words[w];
         read_words[w] = found_words[w];
      }
      copy(ready, waiting);
      copy(waiting, read);
      take(last);
      tag = last.window.tag;
   }

  private:
   /// Member by member: of a copy of the whole record the tool makes one register for several members.
   static HLS_INLINE void copy(Shown& to, const Shown& from) {
      to.cost = from.cost;
      to.winner = from.winner;
      to.place = from.place;
      to.counts = from.counts;
      to.has_before = from.has_before;
      to.row = from.row;
   }

   template <class Slice>
   HLS_INLINE void take(const Slice& last) {
      constexpr uint16_t kFirst = kFalls ? 0 : C.disparities - kLanes;
      constexpr uint16_t kStep = Rows::column(unsigned(kFalls ? kLanes : -kLanes));
      const bool begins = tag.valid & tag.first_column;
      const bool row_begins = begins & (pass == kPasses - 1);
      const uint16_t first_now = select<uint16_t>(row_begins, kFirst, uint16_t(first + kStep));
      const uint16_t columns_now = select<uint16_t>(begins, 0, uint16_t(columns + (columns != kShown)));
      base = select<uint8_t>(begins, select<uint8_t>(row_begins, 0, uint8_t(base + kLanes)), base);
      pass = at_most<kPasses - 1>(select<uint16_t>(begins, select<uint16_t>(row_begins, 0, uint16_t(pass + 1)), pass));
      const bool had_pass = pass != 0;
      read.cost = last.other.cost[0][last.other.kOldest];
      read.winner = uint8_t(last.other.winner[0][last.other.kOldest] + base);
      read.place = Rows::column(
          select<uint16_t>(begins, first_now, select<uint16_t>(tag.valid, uint16_t(read.place + 1), read.place)));
      read.counts = tag.valid & (columns_now < kShown);
      read.has_before = had_pass & (kFalls ? columns_now < C.output_width_px() - 1 : columns_now >= kLanes);
      read.row = read.row ^ row_begins;
      first = Rows::column(select<uint16_t>(begins, first_now, first));
      columns = at_most<kShown>(select<uint16_t>(tag.valid, columns_now, columns));
   }

   /// The disparities of the passes before are lower.
   HLS_INLINE void join() {
      const Value cost_before = Value(Pack::lane(ready_words, 0));
      const uint8_t winner_before = uint8_t(Pack::lane(ready_words, 1));
      const bool wins = Best::wins(ready.cost, cost_before) | !ready.has_before;
      cost = select<Value>(wins, ready.cost, cost_before);
      winner = select<uint8_t>(wins, ready.winner, winner_before);
      write_place = select<uint16_t>(ready.counts, ready.place, kNoPlace);
      write_address = Rows::address(ready.row, select<uint16_t>(ready.counts, ready.place, kNoPlace));
   }

   HLS_INLINE void ask(const RowWinners<C>& in) {
      const uint16_t d = in.winners.disparity[0];
      // Places of the map's columns do not lead out of their row.
      const uint16_t to = kFalls ? uint16_t(in.address_out + d) : uint16_t(in.address_out + (C.disparities - 1) - d);
      answered = asking;
      asking = in.winners;
      address = wrapped<Rows::kPlaces>(to);
   }

   template <class Settings>
   HLS_INLINE void answer(const Settings& settings) {
      checked = answered;
      const int16_t difference = int16_t(answered.disparity[0] - found[0]);
      int16_t allowed = int16_t(C.left_right_threshold);
      if constexpr (kSetAtRunTime<C>) {
         allowed = int16_t(threshold.value);
         threshold.value =
             select<uint8_t>(is_first_of_frame(asking.tag), settings.left_right_threshold, threshold.value);
      }
      checked.passed[0] = answered.passed[0] & (difference <= allowed) & (difference >= int16_t(-allowed));
   }
};

}  // namespace stereo::block_matching
