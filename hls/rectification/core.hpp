// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rectification/sampler.hpp"
#include "support/schedule.hpp"

namespace stereo::rectification {

/// Rectifies the pairs of two cameras: one call of `clock` is one clock of the hardware. docs/rectification.md defines
/// the result.
///
/// The output is a stream as the input is one, so that a matching core can follow: each valid pair makes one leave,
/// kLatency clocks later, and it is the one of C.lag_rows() rows before. The last rows of a frame leave with the first
/// ones of the next frame, or with kSchedule.flush_groups pairs of any value without start of frame. Pairs that leave
/// between frames are 0. There is no back-pressure: a pair a clock is always taken.
template <const Config& C>
struct Core {
   static_assert(kCanBeBuilt<C>);
   static constexpr const Config& kConfig = C;

   //            a pixel pair
   //            |         \.
   //   clocks   counter    delay          1           place in the frame
   //            grid         |            1           place between the nodes
   //            offsets      |            10          of each camera: to the place in its image
   //            |         /               .
   //            |       sample            3           where the pair is kept; beside it
   //            taps (2)                  .           of each camera: which four pixels
   //            |
   //            sampler                   10          of each camera: their rows, and the weighted sum
   //            |
   //            a pixel pair
   static constexpr int kDelay = 1 + GridPlace<C>::kClocks + Offsets<C>::kClocks - 1;
   static constexpr int kLatency = kDelay + SamplePlace<C>::kClocks + Sampler<C>::kClocks;
   static constexpr Schedule kSchedule = raster_schedule(C, C.width_px, kLatency, C.lag_rows() * C.width_px + 1, 0);

   static constexpr int kSamplerMemory = Offsets<C>::kMemories;
   static constexpr int kRightMemory = kSamplerMemory + Sampler<C>::kMemories;
   static constexpr int kMemories = 2 * kRightMemory;

   LagCounter<C> counter;
   ClockDelay<PixelPair<C>, kDelay> delay;
   GridPlace<C> grid;
   Offsets<C> left_offsets, right_offsets;
   SamplePlace<C> sample;
   TapPlace<C> left_taps, right_taps;
   Sampler<C> left_sampler, right_sampler;
   ClockDelay<bool, Sampler<C>::kClocks> valid, starts;

   /// `memories`: see MemoryBank.
   template <class Source>
   HLS_INLINE explicit Core(Source& memories)
       : left_offsets(memories, MemoryId<0>()),
         right_offsets(memories, MemoryId<kRightMemory>()),
         left_sampler(memories, MemoryId<kSamplerMemory>()),
         right_sampler(memories, MemoryId<kRightMemory + kSamplerMemory>()) {}

   /// In data-flow order.
   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit.block("counter", counter);
      visit.block("delay", delay);
      visit.block("grid", grid);
      visit.block("leftoffsets", left_offsets);
      visit.block("rightoffsets", right_offsets);
      visit.block("sample", sample);
      visit.block("lefttaps", left_taps);
      visit.block("righttaps", right_taps);
      visit.block("leftsampler", left_sampler);
      visit.block("rightsampler", right_sampler);
      visit.block("valid", valid);
      visit.block("starts", starts);
   }

   /// What the registers show in this clock. Does not depend on this clock's input.
   HLS_INLINE CoreInput<C> output() const {
      CoreInput<C> out;
      out.left[0] = pixel_of<C>(left_sampler.pixel.value(), 0);
      out.right[0] = pixel_of<C>(right_sampler.pixel.value(), 0);
      out.start_of_frame = starts.oldest() && valid.oldest();
      out.valid = valid.oldest();
      return out;
   }

   /// The clock edge. Last block first: each reads what the block before it held until now.
   HLS_INLINE void clock(const CoreInput<C>& in, const TableWrite& table) {
      valid.clock(sample.kept_pixels.valid);
      starts.clock(sample.kept_starts);
      left_sampler.clock(left_taps, sample, sample.kept_pixels.left);
      right_sampler.clock(right_taps, sample, sample.kept_pixels.right);
      left_taps.clock(left_offsets, sample);
      right_taps.clock(right_offsets, sample);
      sample.clock(delay.oldest());
      left_offsets.clock(grid, table, !table.right);
      right_offsets.clock(grid, table, table.right);
      grid.clock(counter);
      counter.clock(in.valid, in.start_of_frame);
      delay.clock(pixel_pair<C>(in));
   }
};

}  // namespace stereo::rectification
