// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rectification/parity_bank.hpp"

namespace stereo::rectification {

/// A place in a QuadMemory.
struct QuadPlace {
   uint16_t column;
   uint16_t row;

   /// Member by member, see PixelPair.
   HLS_INLINE QuadPlace& operator=(const QuadPlace& other) {
      column = other.column;
      row = other.row;
      return *this;
   }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("column", column);
      visit("row", row);
   }
};

/// `Columns` x `Rows` words, both even, of which each clock shows any 2x2 neighbours and takes one. 4 clocks: the first
/// word of the rows, then those of ParityBank. A row's product and the sum of an address do not fit into one clock.
/// Memory: Columns x Rows words.
///
/// Words whose rows and columns are even or odd alike share a memory: of any 2x2 neighbours each of the four memories
/// has one. Row 0 follows the last row, as in a ring of rows.
template <class Word, int Columns, int Rows>
struct QuadMemory {
   static_assert(Columns % 2 == 0 && Rows % 2 == 0, "an even number of columns and rows shares four memories");
   static constexpr int kPitch = Columns / 2;
   using Bank = ParityBank<Word, kPitch * Rows / 2>;
   static constexpr int kClocks = 1 + Bank::kClocks;
   static constexpr int kMemories = 4 * Bank::kMemories;

   // clock 1: of the even and the odd row and column of the words that are read, and of the word that is written
   uint16_t even_line, odd_line, write_line;  ///< where the row begins
   uint16_t even_column, odd_column, write_column;
   bool to_even_even, to_even_odd, to_odd_even, to_odd_odd;  ///< which memory takes the word
   Word written;
   Bank even_even, even_odd, odd_even, odd_odd;  ///< row, column
   bool row_odd[kClocks], column_odd[kClocks];   ///< of the upper left word, [0] newest

   template <class Source, int First>
   HLS_INLINE QuadMemory(Source& memories, MemoryId<First>)
       : even_even(memories, MemoryId<First>()),
         even_odd(memories, MemoryId<First + 1>()),
         odd_even(memories, MemoryId<First + 2>()),
         odd_odd(memories, MemoryId<First + 3>()) {
      start(*this);
   }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("even_line", even_line);
      visit("odd_line", odd_line);
      visit("write_line", write_line);
      visit("even_column", even_column);
      visit("odd_column", odd_column);
      visit("write_column", write_column);
      visit("to_even_even", to_even_even);
      visit("to_even_odd", to_even_odd);
      visit("to_odd_even", to_odd_even);
      visit("to_odd_odd", to_odd_odd);
      visit("written", written);
      visit("even_even", even_even);
      visit("even_odd", even_odd);
      visit("odd_even", odd_even);
      visit("odd_odd", odd_odd);
      visit("row_odd", row_odd);
      visit("column_odd", column_odd);
   }

   /// The ready words: the upper left one, the one to the right of it, and those below the two.
   HLS_INLINE void taps(Word (&out)[2][2]) const {
      const bool lower = row_odd[kClocks - 1], right = column_odd[kClocks - 1];
      const Word words[2][2] = {{even_even.ready_word, even_odd.ready_word}, {odd_even.ready_word, odd_odd.ready_word}};
      HLS_UNROLL
      for (int r = 0; r < 2; ++r) {
         HLS_UNROLL
         for (int c = 0; c < 2; ++c) {
            const Word even = select<Word>(right, words[0][1 - c], words[0][c]);
            const Word odd = select<Word>(right, words[1][1 - c], words[1][c]);
            out[r][c] = select<Word>(lower == (r == 0), odd, even);
         }
      }
   }

   /// read: of the upper left word, below Columns - 1 and Rows. write: where `word` goes, if `writes`.
   HLS_INLINE void clock(const QuadPlace& read, bool writes, const QuadPlace& write, Word word) {
      HLS_UNROLL
      for (int i = kClocks - 1; i > 0; --i) {
         row_odd[i] = row_odd[i - 1];
         column_odd[i] = column_odd[i - 1];
      }
      row_odd[0] = read.row % 2 != 0;
      column_odd[0] = read.column % 2 != 0;
      const uint16_t write_to = address(write_line, write_column);
      even_even.clock(address(even_line, even_column), to_even_even, write_to, written);
      even_odd.clock(address(even_line, odd_column), to_even_odd, write_to, written);
      odd_even.clock(address(odd_line, even_column), to_odd_even, write_to, written);
      odd_odd.clock(address(odd_line, odd_column), to_odd_odd, write_to, written);

      // The even one of two neighbours may be the second one.
      odd_column = uint16_t(read.column / 2);
      even_column = uint16_t((read.column + 1) / 2);
      odd_line = line(uint16_t(read.row / 2));
      even_line = line(select<uint16_t>(read.row == Rows - 1, 0, (read.row + 1) / 2));
      write_line = line(uint16_t(write.row / 2));
      write_column = uint16_t(write.column / 2);
      // Without `&&`, of which the front end makes branches around the memories, and then states.
      const bool to_odd_row = write.row % 2 != 0, to_odd_column = write.column % 2 != 0;
      const bool to_even_rows = writes & !to_odd_row, to_odd_rows = writes & to_odd_row;
      to_even_even = to_even_rows & !to_odd_column;
      to_even_odd = to_even_rows & to_odd_column;
      to_odd_even = to_odd_rows & !to_odd_column;
      to_odd_odd = to_odd_rows & to_odd_column;
      written = word;
   }

  private:
   static constexpr int kLastLine = kPitch * (Rows / 2 - 1);

   static HLS_INLINE uint16_t line(uint16_t row) { return at_most<kLastLine>(unsigned(row * kPitch)); }
   static HLS_INLINE uint16_t address(uint16_t first, uint16_t column) {
      return at_most<kPitch * Rows / 2 - 1>(unsigned(first + column));
   }
};

}  // namespace stereo::rectification
