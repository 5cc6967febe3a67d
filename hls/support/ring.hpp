// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "support/memory_bank.hpp"
#include "support/registers.hpp"

namespace stereo {

/// Holds a stream of records of `Count` words back by `Places` - 1 moves. 1 clock. Memory: Places x Count words.
///
/// Reads the oldest record while the newest is written one place behind it: both addresses are registers, and a bubble
/// rewrites a place that the next record overwrites, so that the memory needs no enable.
template <class Word, int Places, int Count>
struct Ring {
   static_assert(Places > 1 || Count == 0, "a ring of one place would show what has just been written");
   static constexpr int kClocks = 1;
   static constexpr int kMemories = Count;

   MemoryBank<Word, Places, Count> memory;
   uint16_t read_address;
   uint16_t write_address;

   template <class Source, int First>
   HLS_INLINE Ring(Source& memories, MemoryId<First> first) : memory(memories, first) {
      start(*this);
   }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("read_address", read_address, Places > 1 ? 1 : 0);
      visit("write_address", write_address);
   }

   /// move: `newest` is a record, not a bubble. `oldest` is a register of the user.
   template <int N>
   HLS_INLINE void clock(const Word (&newest)[N], bool move, Word (&oldest)[N]) {
      memory.read(read_address, oldest);
      memory.write(write_address, newest);
      write_address = select<uint16_t>(move, read_address, write_address);
      const uint16_t read_after = select<uint16_t>(read_address == Places - 1, 0, read_address + 1);
      read_address = at_most<Places - 1>(select<uint16_t>(move, read_after, read_address));
   }
};

}  // namespace stereo
