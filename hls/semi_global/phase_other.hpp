// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cost/costs.hpp"
#include "semi_global/phases.hpp"
#include "support/memory_bank.hpp"
#include "support/packed.hpp"

namespace stereo::semi_global {

/// The other image's winners from the sums of a phase a clock: what DiagonalMinimum is for all disparities at once.
/// Each of its pixels goes through the lanes and phases while the columns come, in the order of the lanes, or against
/// it where rows are turned round. Memory: D x (bits of a sum + 8), LUT RAM.
template <const Config& C>
struct PhaseOther {
   using At = Stages<C>;
   static constexpr const auto& kSumsOf = kSumConfig<C>;
   static constexpr int kPhases = At::kPhases;
   static constexpr int kLanes = At::kLanes;
   static constexpr bool kRises = !C.path_right;                    ///< pixels enter at lane 0 of phase 0
   static constexpr bool kFalls = C.reference == Reference::right;  ///< lane 0 of phase 0 has the highest disparity
   using Value = WindowCost<kSumConfig<C>>;
   static constexpr int kCostBits = bits_for(C.largest_sum() + (C.full_width ? 1 : 0));
   static constexpr int kWinnerBits = bits_for(C.disparities - 1);
   using Pack = Packed<(kCostBits > kWinnerBits ? kCostBits : kWinnerBits), 2 * kLanes>;
   using Word = typename Pack::Word;
   using Memory = MemoryBank<Word, kPhases, Pack::kWords>;
   static constexpr int kMemories = Memory::kMemories;
   static constexpr uint8_t kFirstBase = kFalls ? C.disparities - 1 : 0;

   Memory memory;
   PhaseCount<kPhases> read_count;  // 2 clocks before the sums
   Word next_words[Pack::kWords];   // 1
   // beside the sums
   Word words[Pack::kWords];
   PhaseCount<kPhases> count;
   uint8_t base;  ///< the disparity of lane 0
   bool first_column, output_column;
   Value handed_cost;  ///< of the last lane of the phase before
   uint8_t handed_winner;
   // a clock behind them
   Value cost[kLanes];  ///< the best so far of the pixel that meets this lane
   uint8_t winner[kLanes];
   PhaseCount<kPhases> write_count;
   uint8_t left;  ///< the winner of the pixel that has met all disparities; from phase 0 of this stage on

   template <class Source, int First>
   HLS_INLINE PhaseOther(Source& memories, MemoryId<First> first) : memory(memories, first) {
      start(*this);
   }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("read_count", read_count);
      visit("next_words", next_words);
      visit("words", words);
      visit("count", count);
      visit("base", base);
      visit("first_column", first_column);
      visit("output_column", output_column);
      if constexpr (kRises) {
         visit("handed_cost", handed_cost);
         visit("handed_winner", handed_winner);
      }
      visit("cost", cost);
      visit("winner", winner);
      visit("write_count", write_count);
      if constexpr (!kRises) visit("left", left);
   }

   /// At the last phase of the stage behind the sums.
   HLS_INLINE uint8_t leaving() const {
      if constexpr (kRises) return winner[kLanes - 1];
      else return left;
   }

   /// mask: with full_width, of the sums.
   template <class Paths, class Line, class Mask>
   HLS_INLINE void clock(const Paths& paths, const Line& line, const Mask& mask) {
      Word stored[Pack::kWords], kept[Pack::kWords];
      typename Pack::Lane lanes[2 * kLanes];
      HLS_UNROLL
      for (int l = 0; l < kLanes; ++l) {
         lanes[l] = typename Pack::Lane(cost[l]);
         lanes[kLanes + l] = typename Pack::Lane(winner[l]);
      }
      Pack::pack(lanes, kept);
      memory.read(read_count.phase, stored);
      memory.write(write_count.phase, kept);
      if constexpr (!kRises) left = select<uint8_t>(write_count.is_first(), winner[0], left);
      meet(paths, line.template is_there<At::kSums>(), mask);
      if constexpr (kRises) {
         handed_cost = cost_of(words, kLanes - 1);
         handed_winner = winner_of(words, kLanes - 1);
      }
      HLS_UNROLL
      for (int w = 0; w < Pack::kWords; ++w) {
         words[w] = next_words[w];
         next_words[w] = stored[w];
      }
      const bool comes = line.template is_there<At::kSums - 1>();
      const auto& place = line.template at<At::kSums - 1>().shown;
      first_column = select<bool>(comes, place.first_column, first_column);
      output_column = select<bool>(comes, place.output_column, output_column);
      base = select<uint8_t>(comes, kFirstBase, uint8_t(kFalls ? base - kLanes : base + kLanes));
      count.clock(comes);
      read_count.clock(line.template is_there<At::kSums - 3>());
   }

  private:
   static HLS_INLINE Value cost_of(const Word (&from)[Pack::kWords], int lane) { return Value(Pack::lane(from, lane)); }
   static HLS_INLINE uint8_t winner_of(const Word (&from)[Pack::kWords], int lane) {
      return uint8_t(Pack::lane(from, kLanes + lane));
   }

   /// The older costs are those of larger disparities where the sums' reference is the right image.
   static HLS_INLINE bool beats(Value now, Value old) {
      constexpr bool kLargerAreOlder = kSumsOf.reference == Reference::right;
      return kLargerAreOlder == (C.ties == Ties::smallest) ? now <= old : now < old;
   }

   template <class Paths, class Mask>
   HLS_INLINE void meet(const Paths& paths, bool comes, [[maybe_unused]] const Mask& mask) {
      const bool move = write_count.moves(comes);
      HLS_UNROLL
      for (int l = 0; l < kLanes; ++l) {
         const bool enters = kRises ? l == 0 && count.is_first() : l == kLanes - 1 && count.is_last();
         const Value now = paths.shown(l);
         Value old = old_cost(l);
         const bool has_rival = (!first_column) & (!enters);
         bool wins = output_column & ((!has_rival) | beats(now, old));
         if constexpr (C.full_width) {
            wins = wins & mask.has_candidate(l);
            if constexpr (Mask::kLeavesOut) old = select<Value>(has_rival, old, kMaskedCost<kSumConfig<C>>);
         }
         const uint8_t disparity = uint8_t(kFalls ? base - l : base + l);
         cost[l] = select<Value>(move, select<Value>(wins, now, old), cost[l]);
         winner[l] = select<uint8_t>(move, select<uint8_t>(wins, disparity, old_winner(l)), winner[l]);
      }
      write_count.clock(comes);
   }
   HLS_INLINE Value old_cost(int l) const {
      if constexpr (kRises) return l == 0 ? handed_cost : cost_of(words, l > 0 ? l - 1 : 0);
      else return l == kLanes - 1 ? cost_of(next_words, 0) : cost_of(words, l < kLanes - 1 ? l + 1 : 0);
   }
   HLS_INLINE uint8_t old_winner(int l) const {
      if constexpr (kRises) return l == 0 ? handed_winner : winner_of(words, l > 0 ? l - 1 : 0);
      else return l == kLanes - 1 ? winner_of(next_words, 0) : winner_of(words, l < kLanes - 1 ? l + 1 : 0);
   }
};

}  // namespace stereo::semi_global
