// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cost/column_cost.hpp"
#include "cost/window_sum.hpp"
#include "dynamic_range/search_rows.hpp"
#include "winner/gated_tree.hpp"

namespace stereo::dynamic_range {

/// The codes that a search window compares, one for each of its disparities, for the row that enters the matching
/// windows and the one that leaves them. When the window moves on by a column, it takes 1 code; when it rises too, 4;
/// when it falls, none. 1 clock.
template <const Config& C, const auto& Window>
struct WindowChain {
   static constexpr int kClocks = 1;
   static constexpr int kLanes = C.window_disparities;
   static constexpr int kBanks = Config::kBank;
   using Code = Feature<Window>;

   Code lane[2][kLanes];

   HLS_INLINE WindowChain() { start(*this); }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("lane", lane);
   }

   HLS_INLINE void clock(const SearchRows<C, Window>& rows, int track, bool move) {
      HLS_UNROLL
      for (int row = 0; row < 2; ++row) {
         const bool four = rows.step.four[track][row], moves = move & (four | rows.step.one[track][row]);
         HLS_UNROLL
         for (int i = 0; i < kLanes; ++i) {
            const Code one_on = i + 1 < kLanes ? lane[row][i + 1 < kLanes ? i + 1 : 0] : rows.codes[track][row][0];
            const Code four_on = i + kBanks < kLanes
                                     ? lane[row][i + kBanks < kLanes ? i + kBanks : 0]
                                     : rows.codes[track][row][i + kBanks < kLanes ? 0 : i + kBanks - kLanes];
            lane[row][i] = select<Code>(moves, select<Code>(four, four_on, one_on), lane[row][i]);
         }
      }
   }
};

/// One search window: its codes, the sums of their costs with recursive sums, and the best of them.
template <const Config& C, const auto& Window>
struct SearchWindow {
   static constexpr int kLanes = C.window_disparities;
   using Chain = WindowChain<C, Window>;
   using Column = RecursiveColumn<Window, kLanes>;
   using Sums = RunningWindowSum<Window, kLanes>;
   static constexpr bool kGated = can_be_gated<WindowCandidate<Window>>(kLanes, C.winner_group);
   static constexpr int kLevels = winner_clocks(kGated, kLanes, C.winner_group);
   using Winner = WinnerBlock<kGated, WindowCandidate<Window>, PixelTag, 1, C.winner_group, kLanes, kLevels>;
   static constexpr int kMemories = Column::kMemories + Sums::kMemories;
   static constexpr int kClocks = Chain::kClocks + Column::kClocks + Sums::kClocks + kLevels;

   Chain chain;
   Column column;
   Sums sums;
   Winner winner;

   template <class Source, int First>
   HLS_INLINE SearchWindow(Source& memories, MemoryId<First> first)
       : column(memories, first), sums(memories, MemoryId<First + Column::kMemories>()) {}

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit.block("chain", chain);
      visit.block("cost", column);
      visit.block("window", sums);
      winner.levels(visit);
   }

   /// `compared`: what belongs to the chain's codes.
   template <class References>
   HLS_INLINE void clock(const SearchRows<C, Window>& rows, int track, const References& compared, bool move) {
      winner.clock(sums.sum, sums.tag);
      sums.clock(column);
      Seen seen;
      HLS_UNROLL
      for (int tap = 0; tap < 2; ++tap) {
         const int row = tap == 0 ? kLeaving : kEntering;
         seen.reference[tap] = compared.reference[tap];
         HLS_UNROLL
         for (int i = 0; i < kLanes; ++i)
            seen.search[tap][i] = select<Feature<Window>>(compared.inside[tap], chain.lane[row][i], 0);
      }
      seen.tag = compared.tag;
      column.clock(seen);
      chain.clock(rows, track, move);
   }

  private:
   /// What the cost takes: 0 in both images where the row is outside the image.
   struct Seen {
      Feature<Window> search[2][kLanes], reference[2];
      PixelTag tag;
   };
};

}  // namespace stereo::dynamic_range
