// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "block_matching/config.hpp"
#include "block_matching/disparity_slice.hpp"
#include "block_matching/settings.hpp"
#include "block_matching/texture.hpp"
#include "frontend/image_size.hpp"
#include "frontend/line_buffer.hpp"
#include "frontend/pair_delay.hpp"
#include "frontend/raster.hpp"
#include "frontend/transform.hpp"
#include "postprocessing/post_processor.hpp"
#include "support/blocks.hpp"
#include "support/optional_block.hpp"
#include "support/pixel_bits.hpp"
#include "support/schedule.hpp"
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

   using Slices = DisparitySlice<C>;
   /// What makes the map of the winners. Whole disparities without a median are ready as they are.
   using MapBlock = std::conditional_t<C.has_post_processing(), PostProcessor<C>,
                                       std::conditional_t<C.median, Median<C>, Optional<C.subpixel, MapRegister<C>>>>;
   static constexpr bool kHasMapBlock = C.median || C.subpixel || C.has_post_processing();
   using Settings =
       std::conditional_t<C.run_time_size, SizedSettings<block_matching::Settings>, block_matching::Settings>;
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
   //            leftright                 4 or none   also from the slices, ahead of the refinement
   //            map                       11, 1, none median or register; or PostProcessor::kClocks
   //                 |
   //            P disparities
#define STEREO_BLOCKS(BLOCK, BESIDE, PORTS)                                                                          \
   PORTS(settings, SettingsBlock)                                                                                    \
   PORTS(size, Size)                                                                                                 \
   BLOCK(transform, Optional<C.has_transform(), Transform<C>>)                                                       \
   BLOCK(raster, Raster<C>)                                                                                          \
   BLOCK(delay, PairDelay<C>)                                                                                        \
   BLOCK(rows, LineBuffer<C>)                                                                                        \
   BLOCK(slices, Slices)                                                                                             \
   BESIDE(texture, Optional<C.has_texture_check(), Texture<C, Slices::kClocks>>)                                     \
   BLOCK(refinement, Refinement<C>)                                                                                  \
   BLOCK(leftright, Optional<C.has_left_right_check(), LeftRightCheck<C, Slices::kLevels + Refinement<C>::kClocks>>) \
   BLOCK(map, MapBlock)
   STEREO_CORE(STEREO_BLOCKS);
#undef STEREO_BLOCKS

   static constexpr Schedule kSchedule = window_schedule(C, C, kBlocks.all());
   static_assert(!C.run_time_settings || kBlocks.before(map_number).clocks < C.clocks_to_last_check(),
                 "the bound in Config is too low");

   /// What the registers show in this clock. Does not depend on this clock's input.
   HLS_INLINE auto output() const { return shown(shown_group()); }

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
      if constexpr (C.has_post_processing()) map.clock(checked(), size, settings);
      else if constexpr (C.median) map.clock(checked(), size);
      else map.clock(checked());
   }

   HLS_INLINE void check() {
      const auto& other = slices.last().other;
      uint8_t other_winner[C.pixels_per_clock];
      HLS_UNROLL
      for (int p = 0; p < C.pixels_per_clock; ++p) other_winner[p] = other.winner[p][other.kOldest];
      leftright.clock(refinement.output(slices.last(), texture), other_winner, settings);
   }

   HLS_INLINE Winners<C> checked() const {
      if constexpr (C.has_left_right_check()) return leftright.checked;
      else return refinement.output(slices.last(), texture);
   }

   HLS_INLINE MapGroup<C> shown_group() const {
      if constexpr (C.has_post_processing()) return map.group();
      else if constexpr (kHasMapBlock) return map.out;
      else return map_group<C>(checked());
   }
};

}  // namespace stereo::block_matching
