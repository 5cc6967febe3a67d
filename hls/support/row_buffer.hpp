// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "support/memory_bank.hpp"
#include "support/packed.hpp"
#include "support/registers.hpp"

namespace stereo {

/// Keeps the last `Stored` rows of one image of `Width` columns and shows columns of them and of the newest `Pixels`
/// rows. 2 clocks. Memory: Width x Stored x LaneBits bits.
///
/// Clock 1 reads the stored column, clock 2 only waits, since block RAM is slow to show its data. The user of the shown
/// column writes it back, aged, in clock 3. Addresses and data of all accesses come straight from registers, so a
/// synthesiser can fold the memories into block RAM or LUT RAM. Between bubbles the last write is repeated.
template <int LaneBits, int Pixels, int Stored, int Width>
struct RowBuffer {
   using Lane = uint_of_bits<LaneBits>;
   using Pack = Packed<LaneBits, Stored>;
   using Word = typename Pack::Word;
   static constexpr int kWords = Pack::kWords;
   static constexpr int kClocks = 2;
   static constexpr int kMemories = kWords;

   MemoryBank<Word, Width, kWords> memory;
   Word read_words[kWords];  // clock 1
   Lane read_newest[Pixels];
   Word ready_words[kWords];  // clock 2
   Lane ready_newest[Pixels];
   Word write_words[kWords];  // clock 3

   template <class Source, int First>
   HLS_INLINE RowBuffer(Source& memories, MemoryId<First> first) : memory(memories, first) {
      start(*this);
   }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("read_words", read_words);
      visit("read_newest", read_newest);
      visit("ready_words", ready_words);
      visit("ready_newest", ready_newest);
      visit("write_words", write_words);
   }

   /// Row of the ready column: 0 is the oldest, Stored ... Stored + Pixels - 1 are the newest.
   HLS_INLINE Lane row(int index) const {
      return index < Stored ? Pack::lane(ready_words, index < Stored ? index : 0)
                            : ready_newest[index < Stored ? 0 : index - Stored];
   }

   /// `newest`: of the column read_column; ready_valid: the ready column is no bubble; write_column: register with the
   /// column of the last aged column.
   HLS_INLINE void clock(const Lane (&newest)[Pixels], uint16_t read_column, bool ready_valid, uint16_t write_column) {
      Word stored[kWords], aged[kWords];
      memory.read(read_column, stored);
      memory.write(write_column, write_words);
      Lane rows[Stored];
      HLS_UNROLL
      for (int i = 0; i < Stored; ++i) rows[i] = row(i + Pixels);
      Pack::pack(rows, aged);
      HLS_UNROLL
      for (int w = 0; w < kWords; ++w) {
         write_words[w] = select<Word>(ready_valid, aged[w], write_words[w]);
         ready_words[w] = read_words[w];
         read_words[w] = stored[w];
      }
      HLS_UNROLL
      for (int p = 0; p < Pixels; ++p) {
         ready_newest[p] = read_newest[p];
         read_newest[p] = newest[p];
      }
   }
};

}  // namespace stereo
