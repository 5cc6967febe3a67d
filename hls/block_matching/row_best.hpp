// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "block_matching/folding.hpp"
#include "frontend/pixel_tag.hpp"
#include "support/memory_bank.hpp"
#include "support/packed.hpp"
#include "winner/candidate.hpp"
#include "winner/candidates.hpp"

namespace stereo::block_matching {

/// The best candidate of each column of a row: those of the passes so far are kept, and meet those of the pass that is
/// shown. Stands where the last slice stands in a core that is not folded; its tags are those of the last pass. 5
/// clocks: what comes out of a memory is compared in one and chosen in the next. Memory: the next power of two from W
/// on x what a candidate carries.
template <const auto& C>
struct RowBest {
   using Best = WindowCandidate<C>;
   using Others = WindowLosers<C>;
   using Value = typename Best::Value;
   static constexpr int kPixels = 1;
   static constexpr int kClocks = 5;
   static_assert(kClocks == C.kColumnsToBest, "Config counts the clocks in which a pass's candidates come into memory");
   static constexpr int kPasses = C.clocks_per_pixel;
   static constexpr int kLanes = Best::kHasNeighbours ? 5 : 2;
   static constexpr int kCostBits = bits_for(C.largest_window_cost());
   static constexpr int kLaneBits = kCostBits > bits_for(C.disparities - 1) ? kCostBits : bits_for(C.disparities - 1);
   static constexpr int kLoserBits = bits_for(Others::kNone);
   static constexpr int kPlaces = TwoRows<C>::kColumns;
   static constexpr uint8_t kNoneBefore = 255;        ///< one below 0, as bytes count
   static constexpr uint16_t kNoPlace = kPlaces - 1;  ///< a map without full_width is narrower than its image
   using Pack = Packed<kLaneBits, kLanes>;
   using LoserPack = Packed<kLoserBits, 2>;
   static constexpr int kLoserWords = Best::kHasSecond ? LoserPack::kWords : 0;
   using Memory = MemoryBank<typename Pack::Word, kPlaces, Pack::kWords>;
   using LoserMemory = MemoryBank<typename LoserPack::Word, kPlaces, kLoserWords>;
   static constexpr int kMemories = Memory::kMemories + LoserMemory::kMemories;

   Memory memory;
   LoserMemory loser_memory;  ///< losers come a clock after their candidate
   using Here = Candidates<Best, 1, 1>;
   using Lane = typename Pack::Lane;
   static constexpr bool kHasSecond = Best::kHasSecond;
   // clock 1
   Here read;
   PixelTag read_tag;
   uint16_t column, late_column;
   // clock 2
   Here waiting;
   PixelTag waiting_tag;
   typename Pack::Word read_words[Pack::kWords];
   typename LoserPack::Word read_losers[LoserPack::kWords];
   // clock 3
   Here ready;
   PixelTag ready_tag;
   typename Pack::Word ready_words[Pack::kWords];
   typename LoserPack::Word ready_losers[LoserPack::kWords];
   uint16_t pass;  ///< of `ready`
   uint8_t base;   ///< its lowest disparity
   /// The highest disparity before it: a register, as the tool finds no integers for what it makes of base - 1.
   uint8_t last_before;
   // clock 4: which of the two wins
   Here compared;  ///< `ready`, with its disparity among all
   PixelTag compared_tag;
   typename Pack::Word compared_words[Pack::kWords];
   typename LoserPack::Word compared_losers[LoserPack::kWords];
   bool first_pass, last_pass;
   bool here_wins;       ///< against the passes before
   bool here_is_first;   ///< the winner of the pass is its first disparity
   bool before_is_last;  ///< that of the passes before is their last one
   // clock 5
   Here best;
   PixelTag best_tag;
   uint16_t place_column, write_column, late_write_column;
   Value kept_cost;  ///< that `best` met
   bool was_first;   ///< in the first pass

   template <class Source, int First>
   HLS_INLINE RowBest(Source& memories, MemoryId<First> first)
       : memory(memories, first), loser_memory(memories, MemoryId<First + Memory::kMemories>()) {
      start(*this);
   }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("read", read);
      visit("read_tag", read_tag);
      visit("column", column);
      visit("late_column", late_column);
      visit("waiting", waiting);
      visit("waiting_tag", waiting_tag);
      visit("read_words", read_words);
      visit("read_losers", read_losers);
      visit("ready", ready);
      visit("ready_tag", ready_tag);
      visit("ready_words", ready_words);
      visit("ready_losers", ready_losers);
      visit("pass", pass, kPasses - 1);
      visit("base", base);
      visit("last_before", last_before, kNoneBefore);
      visit("compared", compared);
      visit("compared_tag", compared_tag);
      visit("compared_words", compared_words);
      visit("compared_losers", compared_losers);
      visit("first_pass", first_pass);
      visit("last_pass", last_pass);
      visit("here_wins", here_wins);
      visit("here_is_first", here_is_first);
      visit("before_is_last", before_is_last);
      visit("best", best);
      visit("best_tag", best_tag);
      visit("place_column", place_column);
      visit("write_column", write_column);
      visit("late_write_column", late_write_column);
      visit("kept_cost", kept_cost);
      visit("was_first", was_first);
   }

   /// last: the last slice of the lanes.
   template <class Slice>
   HLS_INLINE void clock(const Slice& last) {
      Lane lanes[kLanes];
      typename Pack::Word found[Pack::kWords], kept[Pack::kWords];
      memory.read(column, found);
      write_out(lanes);
      Pack::pack(lanes, kept);
      memory.write(write_column, kept);
      if constexpr (kHasSecond) keep_losers();
      join();
      compare();
      HLS_UNROLL
      for (int w = 0; w < Pack::kWords; ++w) {
         ready_words[w] = read_words[w];
         read_words[w] = found[w];
      }
      count_passes();
      ready = waiting;
      ready_tag = waiting_tag;
      waiting = read;
      waiting_tag = read_tag;
      late_column = column;
      column = place(last.best_tag, column);
      read = last.best;
      read_tag = last.best_tag;
   }

  private:
   /// Of the column after `before`.
   static HLS_INLINE uint16_t place(const PixelTag& tag, uint16_t before) {
      const uint16_t next = select<uint16_t>(tag.first_column, 0, uint16_t(before + 1));
      return TwoRows<C>::column(select<uint16_t>(tag.valid, next, before));
   }

   HLS_INLINE void count_passes() {
      const bool begins = waiting_tag.valid & waiting_tag.first_column;
      const bool first = pass == kPasses - 1;
      base = select<uint8_t>(begins, select<uint8_t>(first, 0, uint8_t(base + C.pass_disparities())), base);
      const uint8_t last_after = select<uint8_t>(first, kNoneBefore, uint8_t(last_before + C.pass_disparities()));
      last_before = select<uint8_t>(begins, last_after, last_before);
      pass = at_most<kPasses - 1>(select<uint16_t>(begins, select<uint16_t>(first, 0, uint16_t(pass + 1)), pass));
   }

   static HLS_INLINE Best unpacked(const typename Pack::Word (&words)[Pack::kWords]) {
      Best kept;
      kept.cost = Value(Pack::lane(words, 0));
      kept.index = uint8_t(Pack::lane(words, 1));
      if constexpr (Best::kHasNeighbours) {
         kept.below = Value(Pack::lane(words, 2));
         kept.above = Value(Pack::lane(words, 3));
         kept.last = Value(Pack::lane(words, 4));
      }
      return kept;
   }

   /// The disparities of the passes before are lower, and there are none in the first pass.
   HLS_INLINE void compare() {
      const Best before = unpacked(ready_words);
      Best here = ready.get(0, 0);
      const bool first = pass == 0;
      here_wins = first | Best::wins(here.cost, before.cost);
      here_is_first = here.index == 0;
      before_is_last = before.index == last_before;
      first_pass = first;
      last_pass = pass == kPasses - 1;
      compared = ready;
      here.index = uint8_t(base + here.index);
      compared.set(0, 0, here, ready.choice(0, 0));
      compared_tag = ready_tag;
      HLS_UNROLL
      for (int w = 0; w < Pack::kWords; ++w) compared_words[w] = ready_words[w];
   }

   HLS_INLINE void join() {
      const Best before = unpacked(compared_words), here = compared.get(0, 0);
      Best joined;
      joined.cost = select<Value>(here_wins, here.cost, before.cost);
      joined.index = select<uint8_t>(here_wins, here.index, before.index);
      if constexpr (Best::kHasNeighbours) {
         joined.below = select<Value>(here_wins, select<Value>(here_is_first, before.last, here.below), before.below);
         joined.above = select<Value>(here_wins, here.above, select<Value>(before_is_last, here.first, before.above));
         joined.last = here.last;
      }
      best.set(0, 0, joined,
               Choice::chosen(here_wins, Choice::of(0, false, before_is_last),
                              Choice::of(1, here_is_first & !first_pass, false)));
      kept_cost = before.cost;
      was_first = first_pass;
      const PixelTag& now = compared_tag;
      place_column = place(now, place_column);
      write_column = select<uint16_t>(now.valid & now.map_column, place_column, kNoPlace);
      best_tag = now;
      best_tag.map_column = now.map_column & last_pass;
      best_tag.output_column = now.output_column & last_pass;
      best_tag.first_column = now.first_column & last_pass;
      best_tag.start_of_frame = now.start_of_frame & last_pass;
      best_tag.end_of_line = now.end_of_line & last_pass;
   }

   HLS_INLINE void write_out(Lane (&lanes)[kLanes]) const {
      const Best shown = best.get(0, 0);
      lanes[0] = Lane(shown.cost);
      lanes[1] = Lane(shown.index);
      if constexpr (Best::kHasNeighbours) {
         lanes[2] = Lane(shown.below);
         lanes[3] = Lane(shown.above);
         lanes[4] = Lane(shown.last);
      }
   }

   /// All of it a clock behind the candidates.
   HLS_INLINE void keep_losers() {
      using Word = typename LoserPack::Word;
      using LoserLane = typename LoserPack::Lane;
      const Others now = best.losers(0, 0);
      const LoserLane lanes[2] = {LoserLane(now.second), LoserLane(now.but_last)};
      Word kept[LoserPack::kWords], found[LoserPack::kWords];
      LoserPack::pack(lanes, kept);
      loser_memory.read(late_column, found);
      loser_memory.write(late_write_column, kept);
      late_write_column = write_column;
      Others before;
      before.cost = select<Value>(was_first, Others::kNone, kept_cost);
      before.second = select<Value>(was_first, Others::kNone, Value(LoserPack::lane(compared_losers, 0)));
      before.but_last = select<Value>(was_first, Others::kNone, Value(LoserPack::lane(compared_losers, 1)));
      best.join_losers(0, 0, before, compared.losers(0, 0));
      HLS_UNROLL
      for (int w = 0; w < LoserPack::kWords; ++w) {
         compared_losers[w] = ready_losers[w];
         ready_losers[w] = read_losers[w];
         read_losers[w] = found[w];
      }
   }
};

}  // namespace stereo::block_matching
