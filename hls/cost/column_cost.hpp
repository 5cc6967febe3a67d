// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <type_traits>

#include "cost/costs.hpp"
#include "cost/pixel_cost.hpp"
#include "cost/sad_cost.hpp"
#include "cost/sign_memory.hpp"
#include "support/matching_options.hpp"
#include "support/memory_bank.hpp"
#include "support/packed.hpp"

namespace stereo {

/// Sums the costs of a column of B pixels, for P windows one below the other and `Count` disparities. 2 clocks behind
/// the pixels: sums of neighbouring taps (1,2), (3,4), ..., which the windows share; column sums.
template <const auto& C, int Count>
struct DirectColumn {
   static constexpr int kClocks = PixelCost<C, Count>::kClocks + 2;
   static constexpr int kMemories = 0;
   static constexpr int kPixels = C.pixels_per_clock;
   static constexpr int kTaps = C.tap_rows();
   static constexpr int kPairs = (kTaps - 1) / 2;

   PixelCost<C, Count> pixels;
   ColumnCost<C> pair[kPairs + 1][Count];  ///< of taps 2j+1 and 2j+2
   ColumnCost<C> single[kTaps][Count];     ///< only of the taps that stand alone
   PixelTag pair_tag;
   ColumnCost<C> column[kPixels][Count];  ///< 0 in the border columns
   PixelTag tag;

   template <class Source, int Number>
   HLS_INLINE DirectColumn(Source&, MemoryId<Number>) {
      start(*this);
   }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("pixels", pixels);
      visit("pair", pair);
      visit("single", single);
      visit("pair_tag", pair_tag);
      visit("column", column);
      visit("tag", tag);
   }

   template <class Shift>
   HLS_INLINE void clock(const Shift& shift) {
      add_columns();
      HLS_UNROLL
      for (int i = 0; i < Count; ++i) {
         HLS_UNROLL
         for (int j = 0; j < kPairs; ++j)
            pair[j][i] = ColumnCost<C>(pixels.cost[2 * j + 1][i] + pixels.cost[2 * j + 2][i]);
         HLS_UNROLL
         for (int t = 0; t < kTaps; ++t) single[t][i] = pixels.cost[t][i];
      }
      pair_tag = pixels.tag;
      pixels.clock(shift);
   }

  private:
   /// Window p covers the taps p ... p+B-1: whole pairs, and a single tap at each end where no pair begins or ends.
   HLS_INLINE void add_columns() {
      HLS_UNROLL
      for (int p = 0; p < kPixels; ++p) {
         const int pairs = p % 2 == 0 ? (C.window_px - 1) / 2 : C.window_px / 2, last = p + C.window_px - 1;
         HLS_UNROLL
         for (int i = 0; i < Count; ++i) {
            ColumnCost<C> sum = 0;
            HLS_UNROLL
            for (int j = 0; j < pairs; ++j) sum = ColumnCost<C>(sum + pair[p / 2 + j][i]);
            if (p % 2 == 0) sum = ColumnCost<C>(sum + single[p][i]);
            if (last % 2 == 1) sum = ColumnCost<C>(sum + single[last][i]);
            column[p][i] = select<ColumnCost<C>>(pair_tag.border_column, 0, sum);
         }
      }
      tag = pair_tag;
   }
};

/// The same sums from those of the row above: plus the pixel that enters the window, minus the one that leaves it.
/// 4 clocks. Memory: W x Count x bits of a column cost, which hold the sums of the last row of each group.
template <const auto& C, int Count>
struct RecursiveColumn {
   static constexpr int kClocks = PixelCost<C, Count>::kClocks + 2;
   static constexpr int kPixels = C.pixels_per_clock;
   static constexpr int kCostBits = bits_for(C.largest_column_cost());
   using Pack = Packed<kCostBits, Count, word_bits_of(C.width_px, 32)>;  // the width of a folded core: of all passes
   static constexpr int kMemories = Pack::kWords;
   using Word = typename Pack::Word;
   using Change = int32_t;

   MemoryBank<Word, C.width_px, Pack::kWords> memory;
   PixelCost<C, Count> pixels;  // clocks 1 and 2
   uint16_t read_column;        ///< of the columns that pixels.first shows
   Word read_words[Pack::kWords];
   uint16_t change_column;         // clock 2: of pixels.cost
   Change change[kPixels][Count];  // clock 3: what the group's rows up to p add
   Word ready_words[Pack::kWords];
   uint16_t ready_column;
   PixelTag ready_tag;
   ColumnCost<C> column[kPixels][Count];  // clock 4: 0 in the border columns
   uint16_t write_column;
   Word write_words[Pack::kWords];
   PixelTag tag;

   template <class Source, int Number>
   HLS_INLINE RecursiveColumn(Source& memories, MemoryId<Number> first) : memory(memories, first) {
      start(*this);
   }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("pixels", pixels);
      visit("read_column", read_column);
      visit("read_words", read_words);
      visit("change_column", change_column);
      visit("change", change);
      visit("ready_words", ready_words);
      visit("ready_column", ready_column);
      visit("ready_tag", ready_tag);
      visit("column", column);
      visit("write_column", write_column);
      visit("write_words", write_words);
      visit("tag", tag);
   }

   template <class Shift>
   HLS_INLINE void clock(const Shift& shift) {
      Word stored[Pack::kWords];
      memory.read(read_column, stored);
      memory.write(write_column, write_words);
      add();
      HLS_UNROLL
      for (int w = 0; w < Pack::kWords; ++w) {
         ready_words[w] = read_words[w];
         read_words[w] = stored[w];
      }
      sum_changes();
      const uint16_t next_column = select<uint16_t>(shift.tag.row_start, 0, uint16_t(read_column + 1));
      change_column = read_column;
      read_column = at_most<C.width_px - 1>(select<uint16_t>(shift.tag.valid, next_column, read_column));
      pixels.clock(shift);
   }

  private:
   HLS_INLINE void add() {
      Word packed[Pack::kWords];
      using Lane = typename Pack::Lane;
      Lane lanes[Count];
      HLS_UNROLL
      for (int i = 0; i < Count; ++i) {
         const Lane above = select<Lane>(ready_tag.first_group, 0, Pack::lane(ready_words, i));
         HLS_UNROLL
         for (int p = 0; p < kPixels; ++p) {
            const ColumnCost<C> sum =
                ColumnCost<C>(above + change[p][i]) & ColumnCost<C>((uint64_t(1) << kCostBits) - 1);
            column[p][i] = select<ColumnCost<C>>(ready_tag.border_column, 0, sum);
         }
         lanes[i] = Lane(column[kPixels - 1][i]);
      }
      Pack::pack(lanes, packed);
      HLS_UNROLL
      for (int w = 0; w < Pack::kWords; ++w) write_words[w] = select<Word>(ready_tag.valid, packed[w], write_words[w]);
      write_column = select<uint16_t>(ready_tag.valid, ready_column, write_column);
      tag = ready_tag;
   }

   HLS_INLINE void sum_changes() {
      HLS_UNROLL
      for (int i = 0; i < Count; ++i) {
         Change sum = 0;
         HLS_UNROLL
         for (int p = 0; p < kPixels; ++p) {
            sum += Change(pixels.cost[kPixels + p][i]) - Change(pixels.cost[p][i]);
            change[p][i] = sum;
         }
      }
      ready_column = change_column;
      ready_tag = pixels.tag;
   }
};

/// SadCost with the constructor of its relatives.
template <const auto& C, int Count>
struct DirectSadColumn : SadCost<C, Count> {
   static constexpr int kMemories = 0;

   template <class Source, int Number>
   HLS_INLINE DirectSadColumn(Source&, MemoryId<Number>) {}
};

/// SadCost that remembers signs. Its clock also takes the column of the pixels that come two clocks later.
template <const auto& C, int Count>
struct RememberingSadColumn : SadCost<C, Count> {
   using Base = SadCost<C, Count>;
   static constexpr int kMemories = SignMemory<C, Count>::kMemories;

   SignMemory<C, Count> signs;

   template <class Source, int First>
   HLS_INLINE RememberingSadColumn(Source& memories, MemoryId<First> first) : signs(memories, first) {}

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("signs", signs);
      Base::registers(visit);
   }

   template <class Shift>
   HLS_INLINE void clock(const Shift& shift, uint16_t early_column) {
      signs.clock(early_column, static_cast<Base&>(*this), shift);
   }
};

/// SAD without memory of sums.
template <const auto& C, int Count>
using SadColumn = std::conditional_t<C.remembers_signs(), RememberingSadColumn<C, Count>, DirectSadColumn<C, Count>>;

/// The block that sums the costs of a configuration's columns. All have `column`, `tag`, `clock(shift)` and kClocks.
template <const auto& C, int Count>
using ColumnBlock =
    std::conditional_t<C.aggregation == Aggregation::recursive, RecursiveColumn<C, Count>,
                       std::conditional_t<C.cost == Cost::sad, SadColumn<C, Count>, DirectColumn<C, Count>>>;

}  // namespace stereo
