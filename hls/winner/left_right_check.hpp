// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "support/matching_options.hpp"
#include "support/memory_bank.hpp"
#include "support/ring.hpp"
#include "support/settings.hpp"
#include "winner/winners.hpp"

namespace stereo {

/// Compares each winner with that of the other image's pixel that it points at. 4 clocks; winners come out D-1 columns
/// later, when that pixel has met all disparities. Memory: D x P winners, with their margins, and P x the next power of
/// two above D+3 x 8 bits for those of the other image. kAhead: clocks by which the other image's winners are ahead of
/// the reference's.
template <const auto& C, int kAhead>
struct LeftRightCheck {
   static constexpr int kPixels = C.pixels_per_clock;
   static constexpr int kClocks = 4;
   static constexpr int kDelay = C.disparities - 1;
   /// Groups by which the winners come out later.
   static constexpr int kLagGroups = kDelay;
   static constexpr int kOtherPlaces = 1 << bits_for(C.disparities + 3);
   static constexpr int kFractionBits = C.subpixel ? 5 : 0;
   static constexpr int kLaneBits = 9 + kFractionBits;
   static constexpr int kTagBits = 4;
   using Word = uint_of_bits<kPixels * kLaneBits + kTagBits>;
   static constexpr int kWords = kHasMargin<C> ? 2 : 1;  ///< the second one holds the margins
   using Delay = Ring<Word, kDelay + 1, kWords>;
   using Others = MemoryBank<uint8_t, kOtherPlaces, kPixels>;
   static constexpr int kMemories = Delay::kMemories + Others::kMemories;

   uint8_t other[kAhead][kPixels];  ///< [age][p]
   Delay ring;
   bool holds_winners;  ///< a reset leaves the words of the ring, with their tags, as they were
   Others others;
   uint16_t position;  ///< where the other image's winner of this clock is kept
   // clock 1
   Word held[kWords];
   uint16_t held_position;
   bool held_valid;
   // clock 2
   uint16_t address[kPixels];
   Winners<C> asking;
   // clock 3
   uint8_t found[kPixels];
   Winners<C> answered;
   [[no_unique_address]] TakenOver<C, uint8_t> threshold;
   // clock 4
   Winners<C> checked;

   template <class Source, int First>
   HLS_INLINE LeftRightCheck(Source& memories, MemoryId<First> first)
       : ring(memories, first), others(memories, MemoryId<First + Delay::kMemories>()) {
      start(*this);
   }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("other", other);
      visit("ring", ring);
      visit("holds_winners", holds_winners);
      visit("position", position);
      visit("held", held);
      visit("held_position", held_position);
      visit("held_valid", held_valid);
      visit("address", address);
      visit("asking", asking);
      visit("found", found);
      visit("answered", answered);
      if constexpr (kSetAtRunTime<C>) visit("threshold", threshold.value, C.left_right_threshold);
      visit("checked", checked);
   }

   /// other_winner: the winner of the other image's pixel that has just met its last disparity.
   template <class Settings = NoSettings>
   HLS_INLINE void clock(const Winners<C>& in, const uint8_t (&other_winner)[kPixels],
                         const Settings& settings = Settings()) {
      compare();
      if constexpr (kSetAtRunTime<C>)
         threshold.value =
             select<uint8_t>(is_first_of_frame(asking.tag), settings.left_right_threshold, threshold.value);
      others.read_each(address, found);
      answered = asking;
      asking = unpacked(held[0]);
      asking.tag.valid = held_valid;
      if constexpr (kHasMargin<C>) {
         HLS_UNROLL
         for (int p = 0; p < kPixels; ++p) asking.margin.value[p] = uint8_t(held[1] >> (kMarginBits * p)) & kMarginMask;
      }
      HLS_UNROLL
      for (int p = 0; p < kPixels; ++p) {
         const uint16_t d = asking.disparity[p];
         const uint16_t place =
             C.reference == Reference::right ? uint16_t(held_position - kDelay + d) : uint16_t(held_position - d);
         address[p] = wrapped<kOtherPlaces>(place);
      }

      uint8_t newest[kPixels];
      HLS_UNROLL
      for (int p = 0; p < kPixels; ++p) newest[p] = other[kAhead - 1][p];
      others.write(position, newest);
      const bool move = in.tag.valid;
      const bool held_is_new = holds_winners || ring.read_address == 0;  // place 0 is the first that is written
      Word words[kWords];
      words[0] = packed(in);
      if constexpr (kHasMargin<C>) words[1] = packed_margins(in);
      ring.clock(words, move, held);
      held_position = position;
      held_valid = move && held_is_new;
      holds_winners = select<bool>(move, held_is_new, holds_winners);
      position = wrapped<kOtherPlaces>(select<uint16_t>(move, uint16_t(position + 1), position));
      HLS_UNROLL
      for (int p = 0; p < kPixels; ++p) {
         HLS_UNROLL
         for (int age = kAhead - 1; age > 0; --age) other[age][p] = other[age - 1][p];
         other[0][p] = other_winner[p];
      }
   }

  private:
   static constexpr uint8_t kMarginMask = (1 << kMarginBits) - 1;

   static HLS_INLINE Word packed_margins(const Winners<C>& in) {
      Word word = 0;
      HLS_UNROLL
      for (int p = 0; p < kPixels; ++p) word |= Word(Word(in.margin.value[p]) << (kMarginBits * p));
      return word;
   }
   static HLS_INLINE Word packed(const Winners<C>& in) {
      Word word = Word(Word(in.tag.map_column) | Word(in.tag.output_column) << 1 | Word(in.tag.start_of_frame) << 2 |
                       Word(in.tag.end_of_line) << 3);
      HLS_UNROLL
      for (int p = 0; p < kPixels; ++p) {
         Word lane = Word(Word(in.disparity[p]) | Word(in.passed[p]) << 8);
         if constexpr (C.subpixel) lane |= Word(Word(in.fraction[p]) << 9);
         word |= Word(lane << (kTagBits + kLaneBits * p));
      }
      return word;
   }
   static HLS_INLINE Winners<C> unpacked(Word word) {
      Winners<C> out;
      out.tag.map_column = (word & 1) != 0;
      out.tag.output_column = (word >> 1 & 1) != 0;
      out.tag.start_of_frame = (word >> 2 & 1) != 0;
      out.tag.end_of_line = (word >> 3 & 1) != 0;
      HLS_UNROLL
      for (int p = 0; p < kPixels; ++p) {
         const Word lane = Word(word >> (kTagBits + kLaneBits * p));
         out.disparity[p] = uint8_t(lane);
         out.passed[p] = (lane >> 8 & 1) != 0;
         if constexpr (C.subpixel) out.fraction[p] = uint8_t(lane >> 9 & 31);
      }
      return out;
   }

   HLS_INLINE void compare() {
      checked = answered;
      HLS_UNROLL
      for (int p = 0; p < kPixels; ++p) {
         const int16_t difference = int16_t(answered.disparity[p] - found[p]);
         if constexpr (kSetAtRunTime<C>) {
            const bool consistent =
                (difference <= int16_t(threshold.value)) & (difference >= int16_t(-threshold.value));
            checked.passed[p] = answered.passed[p] & consistent;
         } else {
            const bool consistent = difference <= C.left_right_threshold && difference >= -C.left_right_threshold;
            checked.passed[p] = answered.passed[p] && consistent;
         }
      }
   }
};

}  // namespace stereo
