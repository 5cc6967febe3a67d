// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "block_matching/config.hpp"
#include "block_matching/disparity_slice.hpp"
#include "block_matching/texture.hpp"
#include "frontend/image_size.hpp"
#include "frontend/line_buffer.hpp"
#include "frontend/pair_delay.hpp"
#include "frontend/raster.hpp"
#include "frontend/transform.hpp"
#include "support/optional_block.hpp"
#include "support/pixel_bits.hpp"
#include "support/schedule.hpp"
#include "support/settings.hpp"
#include "winner/left_right_check.hpp"
#include "winner/map_group.hpp"
#include "winner/median.hpp"
#include "winner/refinement.hpp"

namespace stereo::block_matching {

/// The block-matching core: one call of `clock` is one clock of the hardware. docs/algorithm.md defines the result.
///
/// Input: W*H/P records a frame, any number of bubbles between them. Output: map width * H/P records. A group of P rows
/// leaves while the groups below it come in; after the last group of a frame come the first groups of the next one, or
/// kSchedule.flush_groups groups of any valid pixels without start of frame. There is no back-pressure: a record a
/// clock is always taken.
template <const Config& C>
struct Core {
   static_assert(kCanBeBuilt<C>);
   static constexpr const Config& kConfig = C;
   using Matching = block_matching::Matching;

   using TransformBlock = Optional<C.has_transform(), Transform<C>>;
   using Slices = DisparitySlice<C>;
   using TextureBlock = Optional<C.has_texture_check(), Texture<C, Slices::kClocks>>;
   using CheckBlock = Optional<C.has_left_right_check(), LeftRightCheck<C, Slices::kLevels + Refinement<C>::kClocks>>;
   /// What makes the map of the winners. Whole disparities without a median are ready as they are.
   using MapBlock = std::conditional_t<C.median, Median<C>, Optional<C.subpixel, MapRegister<C>>>;
   static constexpr bool kHasMapBlock = C.median || C.subpixel;
   using Settings = std::conditional_t<C.run_time_size, SizedSettings<CheckSettings>, CheckSettings>;
   using SettingsBlock = std::conditional_t<C.run_time_settings, FrameSettings<C>, NoSettings>;
   using Size = std::conditional_t<C.run_time_size, RunTimeSize<C>, FixedSize<C>>;

   //            P pixel pairs
   //                 |
   //   clocks   transform                 7, 6, none  x-Sobel, census
   //            raster                    1           place in the frame
   //            delay                     1           the reference meets what it is compared with
   //            rows                      3           columns of all rows of the windows
   //              |        \                          .
   //            slices      texture       Slices::kClocks, side by side
   //              |        /                          .
   //            refinement                0, 4, 12    uniqueness, subpixel
   //            left_right                4 or none   also from the slices, ahead of the refinement
   //            map_block                 11, 1, none median or register
   //                 |
   //            P disparities
   static constexpr int kLatency = TransformBlock::kClocks + Raster<C>::kClocks + PairDelay<C>::kClocks +
                                   LineBuffer<C>::kClocks + Slices::kClocks + Refinement<C>::kClocks +
                                   CheckBlock::kClocks + MapBlock::kClocks;
   /// Valid groups that the blocks hold back, up to a row's first window centre and the columns after it.
   static constexpr int kGroupsToFirstOutput = TransformBlock::kLagGroups + LineBuffer<C>::kLagGroups +
                                               C.first_map_column() + C.columns_after() + CheckBlock::kLagGroups +
                                               MapBlock::kLagGroups + 1;
   static constexpr Schedule kSchedule =
       raster_schedule(C, C.output_width_px(), kLatency, kGroupsToFirstOutput, C.gap_groups());

   static_assert(!C.run_time_settings || kLatency < C.clocks_to_last_check(), "the bound in Config is too low");

   // The first memory number of each block.
   static constexpr int kDelayMemory = TransformBlock::kMemories;
   static constexpr int kRowsMemory = kDelayMemory + PairDelay<C>::kMemories;
   static constexpr int kSlicesMemory = kRowsMemory + LineBuffer<C>::kMemories;
   static constexpr int kTextureMemory = kSlicesMemory + Slices::kMemories;
   static constexpr int kCheckMemory = kTextureMemory + TextureBlock::kMemories;
   static constexpr int kMapMemory = kCheckMemory + CheckBlock::kMemories;

   [[no_unique_address]] SettingsBlock settings;
   [[no_unique_address]] Size size;
   TransformBlock transform;
   Raster<C> raster;
   PairDelay<C> delay;
   LineBuffer<C> rows;
   Slices slices;
   TextureBlock texture;
   Refinement<C> refinement;
   CheckBlock left_right;
   MapBlock map_block;

   /// `memories`: see MemoryBank.
   template <class Source>
   HLS_INLINE explicit Core(Source& memories)
       : transform(memories, MemoryId<0>()),
         delay(memories, MemoryId<kDelayMemory>()),
         rows(memories, MemoryId<kRowsMemory>()),
         slices(memories, MemoryId<kSlicesMemory>()),
         texture(memories, MemoryId<kTextureMemory>()),
         left_right(memories, MemoryId<kCheckMemory>()),
         map_block(memories, MemoryId<kMapMemory>()) {}

   /// In data-flow order. A group of registers has the block's name; those in slice number s, from 0 in the order in
   /// which they get the pixels, begin with "slice<s>". Where C.cost_clocks joins steps, registers between them are
   /// listed too, though the hardware has only wires there.
   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      if constexpr (C.run_time_settings) visit.block("settings", settings);
      if constexpr (C.run_time_size) visit.block("size", size);
      visit.block("transform", transform);
      visit.block("raster", raster);
      visit.block("delay", delay);
      visit.block("rows", rows);
      slices.slices(visit);
      visit.block("texture", texture);
      visit.block("refinement", refinement);
      visit.block("leftright", left_right);
      visit.block("map", map_block);
   }

   /// What the registers show in this clock. Does not depend on this clock's input.
   HLS_INLINE StereoOutput output() const { return shown(map()); }

   /// The clock edge. Last block first: each reads what the block before it held until now.
   HLS_INLINE void clock(const CoreInput<C>& in) {
      if constexpr (kHasMapBlock) clock_map();
      if constexpr (C.has_left_right_check()) check();
      refinement.clock(slices.last(), texture, settings);
      if constexpr (C.has_texture_check()) texture.clock(rows, settings);
      slices.clock(rows.search, rows.reference, rows.tag, NoRival<C>(), settings, size, rows.ready.column);
      rows.clock(delay);
      delay.clock(raster, size);
      if constexpr (C.has_transform()) {
         raster.clock(transform.output(), size);
         transform.clock(in, size);
      } else {
         raster.clock(grey_values<C>(in), size);
      }
   }

   /// The same where the configuration has run-time settings. `now`: what the ports show. Thresholds count in the clock
   /// of a start of frame; the size is that of all frames from one reset to the next.
   HLS_INLINE void clock(const CoreInput<C>& in, const Settings& now) {
      clock(in);
      if constexpr (C.run_time_settings) settings.clock(in, now);
      if constexpr (C.run_time_size) size.clock(now.image_width, now.image_height);
   }

  private:
   HLS_INLINE void clock_map() {
      if constexpr (C.median) map_block.clock(checked(), size);
      else map_block.clock(checked());
   }

   HLS_INLINE void check() {
      const auto& other = slices.last().other;
      uint8_t other_winner[C.pixels_per_clock];
      HLS_UNROLL
      for (int p = 0; p < C.pixels_per_clock; ++p) other_winner[p] = other.winner[p][other.kOldest];
      left_right.clock(refinement.output(slices.last(), texture), other_winner, settings);
   }

   HLS_INLINE Winners<C> checked() const {
      if constexpr (C.has_left_right_check()) return left_right.checked;
      else return refinement.output(slices.last(), texture);
   }

   HLS_INLINE MapGroup<C> map() const {
      if constexpr (kHasMapBlock) return map_block.out;
      else return map_group<C>(checked());
   }
};

}  // namespace stereo::block_matching
