// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dynamic_range/config.hpp"
#include "dynamic_range/window_bases.hpp"
#include "frontend/features.hpp"
#include "support/memory_bank.hpp"

namespace stereo::dynamic_range {

/// The searched codes of the last B+2 rows, in four banks by column modulo 4, so that four neighbours are read at once,
/// wherever they begin. Each search window reads the row that enters the matching windows and the one that leaves them:
/// all has four copies. Memory: 4 x (B+2) x W codes.
template <const Config& C, const auto& Window>
struct SearchRows {
   static constexpr int kBanks = Config::kBank;
   static constexpr int kReaders = kTracks * 2;
   static constexpr int kRows = C.window_px + 2;
   static constexpr int kRowWords = C.width_px / kBanks;
   /// The words behind the end of the last row may be asked for, not used.
   static constexpr int kWords = kRows * kRowWords + 1;
   using Code = Feature<Window>;
   using Memory = MemoryBank<Code, kWords, kReaders * kBanks>;
   static constexpr int kMemories = Memory::kMemories;
   /// From where the windows stand to the codes: position, addresses, words 2, rotated.
   static constexpr int kClocks = 5;

   /// What the codes are taken for.
   struct Step {
      uint8_t first_bank[kTracks][2];  ///< of the first code
      bool one[kTracks][2], four[kTracks][2];

      template <class Visitor>
      HLS_INLINE void registers(Visitor& visit) {
         visit("first_bank", first_bank);
         visit("one", one);
         visit("four", four);
      }
   };

   Memory memory;
   // The newest code, the row of the memory in which it stands, and the last four.
   Code last[kBanks];
   uint16_t newest_column, newest_row;
   Code write_codes[kBanks];
   uint16_t write_word;
   // clock 1
   uint16_t enter_row, leave_row;  ///< first words of the rows that the windows compare
   uint16_t position[kTracks][2];
   Step wanted;
   // clock 2
   uint16_t address[kReaders * kBanks];
   Step asked;
   Code read_codes[kReaders * kBanks];  // clock 3
   Step read;
   Code ready_codes[kReaders * kBanks];  // clock 4
   Step ready;
   // clock 5
   Code codes[kTracks][2][kBanks];  ///< from the first one on
   Step step;

   template <class Source, int First>
   HLS_INLINE SearchRows(Source& memories, MemoryId<First> first) : memory(memories, first) {
      start(*this);
   }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("last", last);
      visit("newest_column", newest_column);
      visit("newest_row", newest_row);
      visit("write_codes", write_codes);
      visit("write_word", write_word);
      visit("enter_row", enter_row);
      visit("leave_row", leave_row, kFirstLeaving);
      visit("position", position);
      visit("wanted", wanted);
      visit("address", address);
      visit("asked", asked);
      visit("read_codes", read_codes);
      visit("read", read);
      visit("ready_codes", ready_codes);
      visit("ready", ready);
      visit("codes", codes);
      visit("step", step);
   }

   /// newest: the codes that come ahead of the windows.
   HLS_INLINE void clock(const FeatureGroup<Window>& newest, const WindowBases<C>& bases) {
      Code stored[kReaders * kBanks];
      memory.read_each(address, stored);
      write_all();
      HLS_UNROLL
      for (int track = 0; track < kTracks; ++track) {
         HLS_UNROLL
         for (int row = 0; row < 2; ++row) {
            rotate(track, row);
            find_addresses(track, row);
         }
      }
      step = ready;
      ready = read;
      read = asked;
      asked = wanted;
      HLS_UNROLL
      for (int i = 0; i < kReaders * kBanks; ++i) {
         ready_codes[i] = read_codes[i];
         read_codes[i] = stored[i];
      }
      find_positions(bases);
      take(newest);
   }

  private:
   static constexpr int kLastRow = (kRows - 1) * kRowWords;
   static constexpr int kFirstLeaving = 2 * kRowWords;  ///< B rows before is 2 rows behind, of B+2
   static HLS_INLINE uint16_t row_behind(uint16_t row) {
      return select<uint16_t>(row == kLastRow, 0, uint16_t(row + kRowWords));
   }

   HLS_INLINE void write_all() {
      Code all[kReaders * kBanks];
      HLS_UNROLL
      for (int i = 0; i < kReaders * kBanks; ++i) all[i] = write_codes[i % kBanks];
      memory.write(write_word, all);
   }

   /// Clock 5.
   HLS_INLINE void rotate(int track, int row) {
      const uint8_t first = ready.first_bank[track][row];
      const int reader = (track * 2 + row) * kBanks;
      HLS_UNROLL
      for (int j = 0; j < kBanks; ++j) {
         const Code even =
             select<Code>((first & 2) != 0, ready_codes[reader + (j + 2) % kBanks], ready_codes[reader + j]);
         const Code odd = select<Code>((first & 2) != 0, ready_codes[reader + (j + 3) % kBanks],
                                       ready_codes[reader + (j + 1) % kBanks]);
         codes[track][row][j] = select<Code>((first & 1) != 0, odd, even);
      }
   }

   /// Clock 2. A bank before that of the first code has its code one word further.
   HLS_INLINE void find_addresses(int track, int row) {
      const uint16_t at = position[track][row],
                     first_word = uint16_t((row == kEntering ? enter_row : leave_row) + at / kBanks);
      HLS_UNROLL
      for (int bank = 0; bank < kBanks; ++bank)
         address[(track * 2 + row) * kBanks + bank] =
             at_most<kWords - 1>(unsigned(first_word) + unsigned(bank < at % kBanks));
   }

   /// Clock 1.
   HLS_INLINE void find_positions(const WindowBases<C>& bases) {
      const bool row_starts = bases.stands.valid & (bases.stands.column == 0), frame_starts = bases.stands.frame_starts;
      const uint16_t entering = select<uint16_t>(frame_starts, 0, row_behind(enter_row));
      const uint16_t leaving = select<uint16_t>(frame_starts, kFirstLeaving, row_behind(leave_row));
      enter_row = select<uint16_t>(row_starts, entering, enter_row);
      leave_row = select<uint16_t>(row_starts, leaving, leave_row);
      HLS_UNROLL
      for (int track = 0; track < kTracks; ++track) {
         HLS_UNROLL
         for (int row = 0; row < 2; ++row) {
            const uint16_t at = uint16_t(bases.stands.column + bases.from[track][row]);
            position[track][row] = at;
            wanted.first_bank[track][row] = uint8_t(at % kBanks);
            wanted.four[track][row] = bases.rises[track][row];
            wanted.one[track][row] = !bases.rises[track][row] & !bases.falls[track][row];
         }
      }
   }

   HLS_INLINE void take(const FeatureGroup<Window>& newest) {
      const bool starts = newest.valid & newest.start_of_frame;
      const bool line_ends = newest_column == C.width_px - 1;
      const uint16_t beside = select<uint16_t>(line_ends, 0, uint16_t(newest_column + 1));
      const uint16_t column = select<uint16_t>(starts, 0, beside);
      const uint16_t row_after = select<uint16_t>(line_ends, row_behind(newest_row), newest_row);
      const uint16_t row = select<uint16_t>(starts, 0, row_after);
      const bool writes = newest.valid & (column % kBanks == kBanks - 1);
      HLS_UNROLL
      for (int bank = 0; bank < kBanks; ++bank) {
         const Code code = bank == kBanks - 1 ? newest.search[0] : last[bank + 1 < kBanks ? bank + 1 : 0];
         write_codes[bank] = select<Code>(writes, code, write_codes[bank]);
      }
      write_word = at_most<kWords - 1>(select<uint16_t>(writes, uint16_t(row + column / kBanks), write_word));
      HLS_UNROLL
      for (int i = 0; i < kBanks - 1; ++i) last[i] = select<Code>(newest.valid, last[i + 1], last[i]);
      last[kBanks - 1] = select<Code>(newest.valid, newest.search[0], last[kBanks - 1]);
      newest_column = select<uint16_t>(newest.valid, column, newest_column);
      newest_row = select<uint16_t>(newest.valid, row, newest_row);
   }
};

}  // namespace stereo::dynamic_range
