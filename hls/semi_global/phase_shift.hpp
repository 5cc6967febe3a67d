// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "frontend/features.hpp"
#include "frontend/pixel_tag.hpp"
#include "semi_global/phases.hpp"
#include "support/memory_bank.hpp"
#include "support/packed.hpp"

namespace stereo::semi_global {

/// Holds the searched pixels that the reference pixels of one column are compared with, and shows those of a phase a
/// clock: what DisparityShift is for all disparities at once. Lane l of phase p has the pixel that came p * lanes + l
/// columns before the newest one. 3 clocks. Memory: phases x taps x lanes x feature bits, LUT RAM.
template <const Config& C>
struct PhaseShift {
   static constexpr const auto& kWindows = kWindowConfig<C>;
   static constexpr int kClocks = 3;
   static constexpr int kTaps = kWindows.tap_rows();
   static constexpr int kPhases = Stages<C>::kPhases;
   static constexpr int kLanes = Stages<C>::kLanes;
   using Value = Feature<kWindowConfig<C>>;
   using Pack = Packed<kWindows.feature_bits(), kTaps * kLanes>;
   using Word = typename Pack::Word;
   using Memory = MemoryBank<Word, kPhases, Pack::kWords>;
   static constexpr int kMemories = Memory::kMemories;

   Memory memory;
   // clock 1
   Value newest[kTaps], new_reference[kTaps];
   PixelTag new_tag;  ///< valid in each phase
   PhaseCount<kPhases> count;
   // clock 2
   Word read_words[Pack::kWords];
   Value handed_on[kTaps];  ///< the oldest pixels of the phase before
   Value read_reference[kTaps];
   PixelTag read_tag;
   PhaseCount<kPhases> read_count;
   // clock 3
   Value search[kTaps][kLanes], reference[kTaps];
   PixelTag tag;
   uint16_t write_phase;

   template <class Source, int First>
   HLS_INLINE PhaseShift(Source& memories, MemoryId<First> first) : memory(memories, first) {
      start(*this);
   }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("newest", newest);
      visit("new_reference", new_reference);
      visit("new_tag", new_tag);
      visit("count", count);
      visit("read_words", read_words);
      visit("handed_on", handed_on);
      visit("read_reference", read_reference);
      visit("read_tag", read_tag);
      visit("read_count", read_count);
      visit("search", search);
      visit("reference", reference);
      visit("tag", tag);
      visit("write_phase", write_phase, kPhases - 1);
   }

   HLS_INLINE void clock(const Value (&search_in)[kTaps], const Value (&reference_in)[kTaps], const PixelTag& tag_in) {
      Word stored[Pack::kWords], moved[Pack::kWords];
      typename Pack::Lane lanes[kTaps * kLanes];
      memory.read(count.phase, stored);
      HLS_UNROLL
      for (int t = 0; t < kTaps; ++t) {
         HLS_UNROLL
         for (int l = 0; l < kLanes; ++l) lanes[t * kLanes + l] = search[t][l];
      }
      Pack::pack(lanes, moved);
      memory.write(write_phase, moved);

      const bool move = read_tag.valid, first = read_count.is_first();
      HLS_UNROLL
      for (int t = 0; t < kTaps; ++t) {
         const Value enters = select<Value>(first, newest[t], handed_on[t]);
         search[t][0] = select<Value>(move, enters, search[t][0]);
         HLS_UNROLL
         for (int l = 1; l < kLanes; ++l)
            search[t][l] = select<Value>(move, Value(Pack::lane(read_words, t * kLanes + l - 1)), search[t][l]);
         reference[t] = read_reference[t];
         handed_on[t] = Value(Pack::lane(read_words, t * kLanes + kLanes - 1));
         read_reference[t] = new_reference[t];
      }
      tag = read_tag;
      write_phase = read_count.phase;
      HLS_UNROLL
      for (int w = 0; w < Pack::kWords; ++w) read_words[w] = stored[w];
      read_tag = new_tag;
      read_count = count;

      const bool comes = tag_in.valid, goes_on = count.moves(comes);
      HLS_UNROLL
      for (int t = 0; t < kTaps; ++t) {
         newest[t] = select<Value>(comes, search_in[t], newest[t]);
         new_reference[t] = select<Value>(comes, reference_in[t], new_reference[t]);
      }
      take(tag_in, comes);
      new_tag.valid = goes_on;
      count.clock(comes);
   }

  private:
   HLS_INLINE void take(const PixelTag& in, bool comes) {
      new_tag.border_column = select<bool>(comes, in.border_column, new_tag.border_column);
      new_tag.map_column = select<bool>(comes, in.map_column, new_tag.map_column);
      new_tag.output_column = select<bool>(comes, in.output_column, new_tag.output_column);
      new_tag.first_column = select<bool>(comes, in.first_column, new_tag.first_column);
      new_tag.start_of_frame = select<bool>(comes, in.start_of_frame, new_tag.start_of_frame);
      new_tag.end_of_line = select<bool>(comes, in.end_of_line, new_tag.end_of_line);
   }
};

}  // namespace stereo::semi_global
