// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "support/packed.hpp"
#include "support/ring.hpp"

namespace stereo {

/// Holds `Lanes` numbers of `LaneBits` back by `Moves` moves; between moves it stands still. Memory: Moves x Lanes x
/// LaneBits, LUT RAM where there are few moves.
template <int LaneBits, int Lanes, int Moves>
struct MoveDelay {
   static_assert(Moves >= 2, "a single move is a register");
   using Pack = Packed<LaneBits, Lanes>;
   using Lane = typename Pack::Lane;
   using Word = typename Pack::Word;
   using Memory = Ring<Word, Moves, Pack::kWords>;
   static constexpr int kMemories = Memory::kMemories;

   Memory ring;
   Word held[Pack::kWords];

   template <class Source, int First>
   HLS_INLINE MoveDelay(Source& memories, MemoryId<First> first) : ring(memories, first) {
      start(*this);
   }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("ring", ring);
      visit("held", held);
   }

   HLS_INLINE Lane lane(int index) const { return Pack::lane(held, index); }

   HLS_INLINE void clock(const Lane (&lanes)[Lanes], bool move) {
      Word newest[Pack::kWords], oldest[Pack::kWords];
      Pack::pack(lanes, newest);
      ring.clock(newest, move, oldest);
      HLS_UNROLL
      for (int w = 0; w < Pack::kWords; ++w) held[w] = select<Word>(move, oldest[w], held[w]);
   }
};

}  // namespace stereo
