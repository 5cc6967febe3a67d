// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dynamic_range/config.hpp"
#include "frontend/pair_delay.hpp"
#include "support/row_buffer.hpp"

namespace stereo::dynamic_range {

/// The reference's codes of the row that enters the matching windows and of the one that leaves them, beside the codes
/// that the search windows have. Memory: W x B codes.
template <const Config& C, const auto& Window, int Clocks>
struct ComparedRows {
   /// From PairDelay to `shown`.
   static constexpr int kClocks = Clocks;
   using Rows = RowBuffer<Window.feature_bits(), 1, Window.stored_rows(), C.width_px>;
   static constexpr int kMemories = Rows::kMemories;
   static constexpr int kHeld = Clocks - Rows::kClocks;
   static_assert(kHeld >= 1);

   struct Place {
      uint16_t column;
      bool inside[2];
      PixelTag tag;

      HLS_INLINE Place() { start(*this); }

      template <class Visitor>
      HLS_INLINE void registers(Visitor& visit) {
         visit("column", column);
         visit("inside", inside);
         visit("tag", tag);
      }
   };
   /// [0]: the row that leaves, [1]: the one that enters. 0 where it is outside the image.
   struct Codes {
      Feature<Window> reference[2];
      bool inside[2];

      template <class Visitor>
      HLS_INLINE void registers(Visitor& visit) {
         visit("reference", reference);
         visit("inside", inside);
      }
   };

   Rows rows;
   Place read, ready;
   uint16_t write_column;
   Codes held[kHeld];
   PixelTag tags[kHeld];

   template <class Source, int First>
   HLS_INLINE ComparedRows(Source& memories, MemoryId<First> first) : rows(memories, first) {
      start(*this);
   }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("rows", rows);
      visit("read", read);
      visit("ready", ready);
      visit("write_column", write_column);
      visit("held", held);
      visit("tags", tags);
   }

   HLS_INLINE const Codes& shown() const { return held[kHeld - 1]; }
   HLS_INLINE const PixelTag& tag() const { return tags[kHeld - 1]; }
   /// A clock before.
   HLS_INLINE const PixelTag& early_tag() const { return tags[kHeld - 2]; }

   HLS_INLINE void clock(const PairDelay<Window>& in) {
      HLS_UNROLL
      for (int age = kHeld - 1; age > 0; --age) {
         HLS_UNROLL
         for (int tap = 0; tap < 2; ++tap) {
            held[age].reference[tap] = held[age - 1].reference[tap];
            held[age].inside[tap] = held[age - 1].inside[tap];
         }
         tags[age] = tags[age - 1];
      }
      HLS_UNROLL
      for (int tap = 0; tap < 2; ++tap) {
         held[0].reference[tap] = select<Feature<Window>>(ready.inside[tap], rows.row(Window.tap_row(tap)), 0);
         held[0].inside[tap] = ready.inside[tap];
      }
      tags[0] = ready.tag;
      const Feature<Window> newest[1] = {in.reference(0)};
      rows.clock(newest, in.column, ready.tag.valid, write_column);
      write_column = select<uint16_t>(ready.tag.valid, ready.column, write_column);
      ready.column = read.column;
      ready.tag = read.tag;
      read.column = in.column;
      read.tag = in.tag;
      HLS_UNROLL
      for (int tap = 0; tap < 2; ++tap) {
         ready.inside[tap] = read.inside[tap];
         read.inside[tap] = in.row_inside[tap];
      }
   }
};

}  // namespace stereo::dynamic_range
