// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "absolute_difference/config.hpp"
#include "support/optional_block.hpp"
#include "support/packed.hpp"
#include "support/ports.hpp"
#include "support/raster_counter.hpp"
#include "support/ring.hpp"
#include "support/schedule.hpp"

namespace stereo::absolute_difference {

/// Holds results back by C.delay_groups valid groups. 1 clock. Memory: (delay_groups + 1) x (8 P + 3) bits.
template <const Config& C>
struct Delay {
   static constexpr int kPixels = C.pixels_per_clock;
   static constexpr int kClocks = 1;
   static constexpr int kLagGroups = C.delay_groups;
   static constexpr int kFlags = 3;
   using Word = uint_of_bits<8 * kPixels + kFlags>;
   using Memory = Ring<Word, C.delay_groups + 1, 1>;
   static constexpr int kMemories = Memory::kMemories;

   Memory ring;
   Word held[1];
   uint16_t filled;  ///< words that are of this stream: a reset leaves the memory as it was
   bool valid;

   template <class Source, int First>
   HLS_INLINE Delay(Source& memories, MemoryId<First> first) : ring(memories, first) {
      start(*this);
   }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("ring", ring);
      visit("held", held);
      visit("filled", filled);
      visit("valid", valid);
   }

   HLS_INLINE void clock(const Word& newest, bool move) {
      const Word words[1] = {newest};
      ring.clock(words, move, held);
      const bool full = filled == C.delay_groups;
      valid = move && full;
      filled = at_most<C.delay_groups>(select<uint16_t>(move && !full, filled + 1, filled));
   }
};

/// |left - right| of the pixels at the same place: a family as small as one can be, which shows and tests what a family
/// needs.
template <const Config& C>
struct Core {
   static_assert(kCanBeBuilt<C>);
   static constexpr const Config& kConfig = C;
   using Matching = absolute_difference::Matching;
   static constexpr int kPixels = C.pixels_per_clock;
   static constexpr bool kHasDelay = C.delay_groups > 0;
   using DelayBlock = Optional<kHasDelay, Delay<C>>;
   using Counter = RasterCounter<C.width_px, C.row_groups(), 0, false>;
   //   clocks   difference and place 1, magnitude 1, delay 1 or none
   static constexpr int kLatency = 2 + DelayBlock::kClocks;
   static constexpr Schedule kSchedule =
       raster_schedule(C, C.output_width_px(), kLatency, 1 + DelayBlock::kLagGroups, 0);

   // clock 1
   Counter place;
   int16_t difference[kPixels];  ///< left - right
   bool starts, valid;
   // clock 2
   uint8_t magnitude[kPixels];
   bool inside, start_of_frame, end_of_line, magnitude_valid;
   // clock 3
   DelayBlock delay;

   template <class Source>
   HLS_INLINE explicit Core(Source& memories) : delay(memories, MemoryId<0>()) {
      start(*this);
   }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit.block("place", place);
      visit("input_difference", difference);
      visit("input_starts", starts);
      visit("input_valid", valid);
      visit("map_magnitude", magnitude);
      visit("map_inside", inside);
      visit("map_start_of_frame", start_of_frame);
      visit("map_end_of_line", end_of_line);
      visit("map_valid", magnitude_valid);
      visit.block("delay", delay);
   }

   HLS_INLINE StereoOutput output() const {
      if constexpr (kHasDelay) return shown(delay.held[0], delay.valid);
      else return shown(packed(), magnitude_valid);
   }

   HLS_INLINE void clock(const StereoInput& in) {
      if constexpr (kHasDelay) delay.clock(packed(), magnitude_valid);
      magnitude_valid = valid;
      inside = place.group != Counter::kIdle;
      start_of_frame = starts;
      end_of_line = place.column == C.width_px - 1;
      HLS_UNROLL
      for (int p = 0; p < kPixels; ++p) {
         magnitude[p] = uint8_t(select<int16_t>(difference[p] < 0, int16_t(-difference[p]), difference[p]));
         difference[p] = int16_t(in.left[p] - in.right[p]);
      }
      starts = in.start_of_frame;
      valid = in.valid;
      place.clock(in.valid, in.start_of_frame);
   }

  private:
   using Word = uint_of_bits<8 * kPixels + 3>;

   HLS_INLINE Word packed() const {
      Word word = Word(Word(inside) | Word(start_of_frame) << 1 | Word(end_of_line) << 2);
      HLS_UNROLL
      for (int p = 0; p < kPixels; ++p) word |= Word(Word(magnitude[p]) << (3 + 8 * p));
      return word;
   }

   static HLS_INLINE StereoOutput shown(Word word, bool valid) {
      StereoOutput out;
      out.valid = valid && (word & 1) != 0;
      out.start_of_frame = out.valid && (word >> 1 & 1) != 0;
      out.end_of_line = out.valid && (word >> 2 & 1) != 0;
      HLS_UNROLL
      for (int p = 0; p < kPixels; ++p) {
         out.disparity[p] = uint8_t(word >> (3 + 8 * p));
         out.pixel_valid[p] = out.disparity[p] >= C.least_difference;
      }
      return out;
   }
};

}  // namespace stereo::absolute_difference
