// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dynamic_range/config.hpp"
#include "support/memory_bank.hpp"
#include "support/pixel_bits.hpp"
#include "support/registers.hpp"

namespace stereo::dynamic_range {

/// The coarse images: means of 4x4 pixels, each row followed by repetitions of its last pixel. A coarse pixel comes
/// kClocks after the last of its sixteen, a repetition in each clock after that. Memory: W/4 x 2 kSumBits bits.
template <const Config& C>
struct CoarsePixels {
   static constexpr int kClocks = 5;
   static constexpr int kSide = Config::kCoarse;
   static constexpr int kColumns = C.coarse_columns();
   static constexpr int kRepetitions = C.coarse_disparities();
   static constexpr int kSumBits = kPixelBits<C> + bits_for(kSide * kSide - 1);
   using Word = uint32_t;
   using Memory = MemoryBank<Word, kColumns, 1>;
   static constexpr int kMemories = Memory::kMemories;

   Memory memory;
   // clock 1
   Pixel<C> left, right;
   bool valid;
   uint16_t column;    ///< 0 ... W/4-1
   uint8_t part, row;  ///< 0 ... 3: within a coarse pixel
   bool first_row;     ///< the first coarse row of a frame
   // clock 2: sums of up to 4 pixels of a row
   uint16_t left_sum, right_sum;
   bool sum_ends, sum_is_first, sum_is_last, sum_starts;
   uint16_t sum_column;
   // clock 3
   Word read_word[1];
   uint16_t left_read, right_read, read_column;
   bool read_ends, read_is_first, read_is_last, read_starts;
   // clock 4: with the rows above
   Word total;
   bool total_ends, total_is_last, total_starts;
   uint16_t total_column;
   // clock 5
   uint16_t repetition;  ///< of a row's last pixel: kRepetitions behind the last one
   CoreInput<C> out;

   template <class Source, int First>
   HLS_INLINE CoarsePixels(Source& memories, MemoryId<First> first) : memory(memories, first) {
      start(*this);
   }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("left", left);
      visit("right", right);
      visit("valid", valid);
      visit("column", column);
      visit("part", part);
      visit("row", row);
      visit("first_row", first_row);
      visit("left_sum", left_sum);
      visit("right_sum", right_sum);
      visit("sum_ends", sum_ends);
      visit("sum_is_first", sum_is_first);
      visit("sum_is_last", sum_is_last);
      visit("sum_starts", sum_starts);
      visit("sum_column", sum_column);
      visit("read_word", read_word);
      visit("left_read", left_read);
      visit("right_read", right_read);
      visit("read_column", read_column);
      visit("read_ends", read_ends);
      visit("read_is_first", read_is_first);
      visit("read_is_last", read_is_last);
      visit("read_starts", read_starts);
      visit("total", total);
      visit("total_ends", total_ends);
      visit("total_is_last", total_is_last);
      visit("total_starts", total_starts);
      visit("total_column", total_column);
      visit("repetition", repetition, kRepetitions);
      visit("out_left", out.left[0]);
      visit("out_right", out.right[0]);
      visit("out_start", out.start_of_frame);
      visit("out_valid", out.valid);
   }

   HLS_INLINE void clock(const CoreInput<C>& in) {
      Word stored[1];
      memory.read(sum_column, stored);
      const Word totals[1] = {total};
      memory.write(total_column, totals);
      emit();
      add_rows();
      left_read = left_sum;
      right_read = right_sum;
      read_word[0] = stored[0];
      read_column = sum_column;
      read_ends = sum_ends;
      read_is_first = sum_is_first;
      read_is_last = sum_is_last;
      read_starts = sum_starts;
      add_columns();
      count(in);
   }

  private:
   HLS_INLINE void emit() {
      const bool comes = total_ends & total_is_last;
      const bool repeats = repetition != kRepetitions;
      const uint16_t next = select<uint16_t>(repeats, uint16_t(repetition + 1), repetition);
      repetition = select<uint16_t>(comes & (total_column == kColumns - 1), 0, next);
      out.valid = comes | repeats;
      out.start_of_frame = comes & total_starts & (total_column == 0);
      out.left[0] = select<Pixel<C>>(comes, mean(total), out.left[0]);
      out.right[0] = select<Pixel<C>>(comes, mean(total >> kSumBits), out.right[0]);
   }
   static HLS_INLINE Pixel<C> mean(Word sums) {
      constexpr unsigned kPixels = unsigned(kSide * kSide);
      return Pixel<C>(((sums & ((1u << kSumBits) - 1)) + kPixels / 2) / kPixels);
   }

   HLS_INLINE void add_rows() {
      const Word above = select<Word>(read_is_first, 0, read_word[0]);
      const Word sums = sums_with(above);
      total = select<Word>(read_ends, sums, total);
      total_column = select<uint16_t>(read_ends, read_column, total_column);
      total_ends = read_ends;
      total_is_last = read_is_last;
      total_starts = read_starts;
   }

   /// Both images in one addition, where the tool has one of so many bits.
   HLS_INLINE Word sums_with(Word above) const {
      if constexpr (2 * kSumBits < 32) {
         return Word((above + (Word(left_read) | Word(right_read) << kSumBits)) & ((1u << 2 * kSumBits) - 1));
      } else {
         const uint16_t left_sums = uint16_t(uint16_t(above) + left_read);
         const uint16_t right_sums = uint16_t(uint16_t(above >> kSumBits) + right_read);
         return Word(left_sums) | Word(right_sums) << kSumBits;
      }
   }

   HLS_INLINE void add_columns() {
      const uint16_t left_before = select<uint16_t>(part == 0, 0, left_sum);
      const uint16_t right_before = select<uint16_t>(part == 0, 0, right_sum);
      left_sum = select<uint16_t>(valid, uint16_t(left_before + left), left_sum);
      right_sum = select<uint16_t>(valid, uint16_t(right_before + right), right_sum);
      sum_ends = valid & (part == kSide - 1);
      sum_is_first = row == 0;
      sum_is_last = row == kSide - 1;
      sum_starts = first_row;
      sum_column = column;
   }

   HLS_INLINE void count(const CoreInput<C>& in) {
      const bool starts = in.valid & in.start_of_frame;
      const bool part_ends = part == kSide - 1, line_ends = part_ends & (column == kColumns - 1);
      const uint8_t next_part = select<uint8_t>(part_ends, 0, uint8_t(part + 1));
      const uint16_t beside = select<uint16_t>(part_ends, uint16_t(column + 1), column);
      const uint16_t next_column = select<uint16_t>(line_ends, 0, beside);
      const uint8_t below = uint8_t((row + 1) & (kSide - 1));
      const uint8_t next_row = select<uint8_t>(line_ends, below, row);
      const bool next_first = first_row & !(line_ends & (row == kSide - 1));
      part = select<uint8_t>(starts, 0, select<uint8_t>(in.valid, next_part, part));
      column = at_most<kColumns - 1>(select<uint16_t>(starts, 0, select<uint16_t>(in.valid, next_column, column)));
      row = select<uint8_t>(starts, 0, select<uint8_t>(in.valid, next_row, row));
      first_row = starts | select<bool>(in.valid, next_first, first_row);
      left = in.left[0];
      right = in.right[0];
      valid = in.valid;
   }
};

}  // namespace stereo::dynamic_range
