// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "support/memory_bank.hpp"
#include "support/registers.hpp"

namespace stereo::rectification {

/// One memory of a QuadMemory. 3 clocks: the address, the word, and one to wait, since block RAM is slow to show its
/// data. Between writes the last one is repeated, so that the memory needs no enable.
template <class Word, int Depth>
struct ParityBank {
   static constexpr int kClocks = 3;
   static constexpr int kMemories = 1;

   MemoryBank<Word, Depth, 1> memory;
   uint16_t read_address, write_address;  // clock 1
   Word write_word;
   Word read_word;   // clock 2
   Word ready_word;  // clock 3

   template <class Source, int First>
   HLS_INLINE ParityBank(Source& memories, MemoryId<First> first) : memory(memories, first) {
      start(*this);
   }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("read_address", read_address);
      visit("write_address", write_address);
      visit("write_word", write_word);
      visit("read_word", read_word);
      visit("ready_word", ready_word);
   }

   HLS_INLINE void clock(uint16_t read_from, bool write, uint16_t write_to, Word word) {
      ready_word = read_word;
      Word stored[1];
      const Word written[1] = {write_word};
      memory.read(read_address, stored);
      memory.write(write_address, written);
      read_word = stored[0];
      read_address = read_from;
      write_address = select<uint16_t>(write, write_to, write_address);
      write_word = select<Word>(write, word, write_word);
   }
};

}  // namespace stereo::rectification
