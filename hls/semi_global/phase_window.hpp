// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cost/costs.hpp"
#include "semi_global/phases.hpp"
#include "support/memory_bank.hpp"
#include "support/packed.hpp"

namespace stereo::semi_global {

/// Sums the last B column costs of a phase, for a phase a clock: what WindowSum is for all disparities at once. 1
/// clock. Memory: phases x lanes x (B-1) partial sums, LUT RAM.
template <const Config& C>
struct PhaseWindow {
   static constexpr const auto& kWindows = kWindowConfig<C>;
   static constexpr int kClocks = 1;
   using At = Stages<C>;
   static constexpr int kPhases = At::kPhases;
   static constexpr int kLanes = At::kLanes;
   static constexpr int kPartials = kWindows.window_px - 1;
   using Sum = WindowCost<kWindowConfig<C>>;
   using Pack = Packed<bits_for(kWindows.largest_column_cost() * kPartials), kPartials * kLanes>;
   using Word = typename Pack::Word;
   using Lane = typename Pack::Lane;
   using Memory = MemoryBank<Word, kPhases, Pack::kWords>;
   static constexpr int kMemories = Memory::kMemories;

   Memory memory;
   PhaseCount<kPhases> read_count;
   Word read_words[Pack::kWords];     // beside the column costs
   Lane partial[kPartials * kLanes];  ///< [j * lanes + l]: the last j+1 column costs
   PhaseCount<kPhases> write_count;
   Sum sum[1][kLanes];  ///< S(x,y,d)

   template <class Source, int First>
   HLS_INLINE PhaseWindow(Source& memories, MemoryId<First> first) : memory(memories, first) {
      start(*this);
   }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("read_count", read_count);
      visit("read_words", read_words);
      visit("partial", partial);
      visit("write_count", write_count);
      visit("sum", sum);
   }

   template <class Column, class Line>
   HLS_INLINE void clock(const Column& cost, const Line& line) {
      Word stored[Pack::kWords], moved[Pack::kWords];
      memory.read(read_count.phase, stored);
      Pack::pack(partial, moved);
      memory.write(write_count.phase, moved);
      const bool comes = line.template is_there<At::kWindows - 1>();
      const bool move = write_count.moves(comes);
      HLS_UNROLL
      for (int l = 0; l < kLanes; ++l) {
         const Lane newest = Lane(cost.column[0][l]);
         sum[0][l] = Sum(Pack::lane(read_words, (kPartials - 1) * kLanes + l) + newest);
         HLS_UNROLL
         for (int j = 0; j < kPartials; ++j) {
            const int at = j * kLanes + l;
            const Lane before = j == 0 ? Lane(0) : Pack::lane(read_words, j == 0 ? 0 : at - kLanes);
            partial[at] = select<Lane>(move, Lane(before + newest), partial[at]);
         }
      }
      write_count.clock(comes);
      HLS_UNROLL
      for (int w = 0; w < Pack::kWords; ++w) read_words[w] = stored[w];
      read_count.clock(line.template is_there<At::kWindows - 3>());
   }
};

}  // namespace stereo::semi_global
