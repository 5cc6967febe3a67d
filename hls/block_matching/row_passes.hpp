// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "block_matching/folding.hpp"
#include "frontend/line_buffer.hpp"
#include "support/memory_bank.hpp"
#include "support/packed.hpp"

namespace stereo::block_matching {

/// Keeps the columns of taps of two rows: while one comes in, the other one is shown C.clocks_per_pixel times, a column
/// a clock, each time with another distance between the images. Memory: two times 2 x the next power of two from W on x
/// taps x feature bits.
///
///    row y+1 comes in    |0         1         2         3  ...                                   W-1|
///    row y is shown      |pass 0        |pass 1        | ... |pass F-1      |   waits                |
///    row y-1 leaves      |    0         1         2         3  ...                                   |
template <const auto& C>
struct RowPasses {
   static constexpr int kTaps = C.tap_rows();
   static constexpr int kPasses = C.clocks_per_pixel;
   static constexpr int kColumns = C.pass_columns();
   static constexpr int kBehindLast = C.columns_behind_last_pass();
   static constexpr int kFirstCost = C.columns_before_pass();
   static constexpr int kFirstMap = kFirstCost + C.first_map_column() - C.first_cost_column();
   static constexpr int kLastMap = kFirstMap + C.output_width_px() - 1;
   static constexpr bool kFalls = C.reference == Reference::right;
   using Rows = TwoRows<C>;
   /// Columns of the images that a pass begins with, and by which the searched one moves from pass to pass.
   static constexpr int kReference = C.first_cost_column() - C.reference_delay() - kFirstCost;
   static constexpr int kSearch = kReference + (kFalls ? C.min_disparity + C.pass_disparities() - 1 : -C.min_disparity);
   static constexpr uint16_t kReferenceStart = Rows::column(unsigned(kReference));
   static constexpr uint16_t kSearchStart = Rows::column(unsigned(kSearch));
   static constexpr uint16_t kStep = Rows::column(unsigned(kFalls ? C.pass_disparities() : -C.pass_disparities()));
   using Pack = Packed<C.feature_bits(), kTaps>;
   using Word = typename Pack::Word;
   using Memory = MemoryBank<Word, Rows::kPlaces, Pack::kWords>;
   static constexpr int kMemories = 2 * Memory::kMemories;
   static constexpr int kClocks = 1;        ///< of the row that leaves
   static constexpr int kClocksToShow = 4;  ///< from a row's last column to the first column of its first pass
   /// A row that is matched and one that leaves.
   static constexpr int kLagGroups = C.folded_rows() * C.width_px;

   Memory search_rows, reference_rows;
   // the row that comes in
   bool row;  ///< of the two
   RowPlace coming;
   bool coming_inside[kTaps];
   bool row_ended;   ///< in the last clock
   bool ended_last;  ///< the last column that came was a row's last one
   bool arrived;     ///< a column in the last clock
   uint16_t write_address;
   Word write_search[Pack::kWords], write_reference[Pack::kWords];
   // the row that is shown
   bool shows;
   RowPlace showing;
   bool inside[kTaps];  ///< [t]: tap t is a row of the frame
   uint16_t pass, column;
   bool pass_ends;         ///< with this column
   bool last_pass;         ///< from the second column of a pass on
   uint16_t search_start;  ///< column that the next pass begins with
   uint16_t search_address, reference_address;
   // the row that leaves
   RowPlace leaving;
   // clock 1 of a column
   Word read_search[Pack::kWords], read_reference[Pack::kWords];
   PixelTag read_tag;
   // clock 2
   Feature<C> search[kTaps], reference[kTaps];
   PixelTag tag;

   template <class Source, int First>
   HLS_INLINE RowPasses(Source& memories, MemoryId<First> first)
       : search_rows(memories, first), reference_rows(memories, MemoryId<First + Memory::kMemories>()) {
      start(*this);
   }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("row", row);
      visit("coming", coming);
      visit("coming_inside", coming_inside);
      visit("row_ended", row_ended);
      visit("ended_last", ended_last);
      visit("arrived", arrived);
      visit("write_address", write_address);
      visit("write_search", write_search);
      visit("write_reference", write_reference);
      visit("shows", shows);
      visit("showing", showing);
      visit("inside", inside);
      visit("pass", pass);
      visit("column", column);
      visit("pass_ends", pass_ends);
      visit("last_pass", last_pass);
      visit("search_start", search_start, Rows::column(kSearchStart + kStep));
      visit("search_address", search_address, kSearchStart);
      visit("reference_address", reference_address, kReferenceStart);
      visit("leaving", leaving);
      visit("read_search", read_search);
      visit("read_reference", read_reference);
      visit("read_tag", read_tag);
      visit("search", search);
      visit("reference", reference);
      visit("tag", tag);
   }

   HLS_INLINE void clock(const LineBuffer<kFront<C>>& in) {
      HLS_UNROLL
      for (int t = 0; t < kTaps; ++t) {
         search[t] = Pack::lane(read_search, t);
         reference[t] = Pack::lane(read_reference, t);
      }
      tag = read_tag;
      show();
      step();
      take(in);
   }

  private:
   HLS_INLINE void show() {
      search_rows.read(search_address, read_search);
      reference_rows.read(reference_address, read_reference);
      // Columns follow one another: what holds from one on is kept, which is shorter than to compare for the order.
      const bool at_start = column == 0, at_cost = column == kFirstCost, at_map = column == kFirstMap;
      const bool on_map = at_map | (read_tag.map_column & !read_tag.end_of_line);
      read_tag.valid = shows;
      read_tag.row_start = at_start & (pass == 0);
      read_tag.first_group = showing.first_group;
      const bool behind_cost = column == kFirstCost + C.cost_columns();
      read_tag.border_column = (!at_cost) & (read_tag.border_column | at_start | behind_cost);
      read_tag.first_cost = at_cost;
      read_tag.leaves_window = (!at_start) & (read_tag.leaves_window | (column == kFirstCost + C.window_px));
      read_tag.map_column = on_map;
      read_tag.output_column = on_map & showing.output;
      read_tag.first_column = at_map;
      read_tag.start_of_frame = at_map & showing.starts;
      read_tag.end_of_line = column == kLastMap;
   }

   HLS_INLINE uint16_t next(uint16_t address, uint16_t pass_start) const {
      return select<uint16_t>(pass_ends, pass_start, select<uint16_t>(shows, uint16_t(address + 1), address));
   }

   /// At rest everything stands at a row's first column.
   HLS_INLINE void step() {
      const bool row_ends = pass_ends & last_pass;
      const uint16_t last_but_one = select<uint16_t>(last_pass, kColumns + kBehindLast - 2, kColumns - 2);
      const uint16_t pass_start = select<uint16_t>(row_ends, kSearchStart, search_start);
      const uint16_t pass_after =
          select<uint16_t>(row_ends, uint16_t(kSearchStart + kStep), uint16_t(search_start + kStep));
      search_address = Rows::address(!row, next(search_address, pass_start));
      search_start = Rows::column(select<uint16_t>(pass_ends, pass_after, search_start));
      reference_address = Rows::address(!row, next(reference_address, kReferenceStart));
      const bool ends_next = column == last_but_one, last_now = pass == kPasses - 1;
      column = at_most<kColumns + kBehindLast - 1>(
          select<uint16_t>(pass_ends, 0, select<uint16_t>(shows, uint16_t(column + 1), column)));
      pass = at_most<kPasses - 1>(select<uint16_t>(pass_ends, select<uint16_t>(row_ends, 0, uint16_t(pass + 1)), pass));
      shows = select<bool>(shows, !row_ends, row_ended);
      pass_ends = ends_next;
      last_pass = last_now;
   }

   HLS_INLINE void take(const LineBuffer<kFront<C>>& in) {
      const bool valid = in.tag.valid;
      const bool ends = valid & (in.write_column == C.width_px - 1);
      const bool breaks_off = valid & in.tag.row_start & !ended_last;  // a start of frame within a row
      leaving.output = select<bool>(ends, showing.output, leaving.output & !breaks_off);
      leaving.starts = select<bool>(ends, showing.starts, leaving.starts);
      showing.first_group = select<bool>(ends, coming.first_group, showing.first_group);
      showing.output = select<bool>(ends, coming.output, showing.output);
      showing.starts = select<bool>(ends, coming.starts, showing.starts);
      const bool places = valid & in.tag.first_column;
      coming.first_group = select<bool>(places, in.tag.first_group, coming.first_group);
      coming.output = select<bool>(places, in.tag.output_column, coming.output);
      coming.starts = select<bool>(places, in.tag.start_of_frame, coming.starts);

      HLS_UNROLL
      for (int t = 0; t < kTaps; ++t) {
         inside[t] = select<bool>(ends, coming_inside[t], inside[t]);
         coming_inside[t] = select<bool>(places, in.inside[t], coming_inside[t]);
      }

      search_rows.write(write_address, write_search);
      reference_rows.write(write_address, write_reference);
      Word search_words[Pack::kWords], reference_words[Pack::kWords];
      Pack::pack(in.search, search_words);
      Pack::pack(in.reference, reference_words);
      HLS_UNROLL
      for (int w = 0; w < Pack::kWords; ++w) {
         write_search[w] = select<Word>(valid, search_words[w], write_search[w]);
         write_reference[w] = select<Word>(valid, reference_words[w], write_reference[w]);
      }
      arrived = valid;
      write_address = select<uint16_t>(valid, Rows::address(row, in.write_column), write_address);
      row = row ^ ends;
      row_ended = ends;
      ended_last = select<bool>(valid, ends, ended_last);
   }
};

}  // namespace stereo::block_matching
