// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "block_matching/core.hpp"
#include "block_matching/row_best.hpp"
#include "block_matching/row_check.hpp"
#include "block_matching/row_passes.hpp"
#include "block_matching/row_winners.hpp"

namespace stereo::block_matching {

/// The same core with C.clocks_per_pixel clocks a pixel pair: the same map, two rows of pairs later, and as before one
/// disparity for each pair, the same number of clocks behind it. A pair must not come sooner than clocks_per_pixel
/// clocks after the one before it, start of frame or not.
template <const Config& C>
   requires(C.is_folded())
struct Core<C> {
   static_assert(kCanBeBuilt<C>);
   static constexpr const Config& kConfig = C;
   using Matching = block_matching::Matching;

   using Lanes = DisparitySlice<kLanes<C>>;
   using TextureBlock = Texture<kLanes<C>, Lanes::kClocks + RowBest<C>::kClocks>;
   using MapBlock = std::conditional_t<C.has_post_processing(), PostProcessor<C>,
                                       std::conditional_t<C.median, Median<C>, Optional<C.subpixel, MapRegister<C>>>>;
   static constexpr bool kHasMapBlock = C.median || C.subpixel || C.has_post_processing();
   using Settings = block_matching::Settings;
   using SettingsBlock = std::conditional_t<C.run_time_settings, FrameSettings<C>, NoSettings>;

   //          a pixel pair                      once in F clocks
   //               |
   //   clocks  transform             7, 6, none  x-Sobel, census; census 7 with two front clocks
   //           raster, delay, rows   5           columns of all rows of the windows
   //           passes                1           two rows: one comes in, one is shown F times
   //               |    \              .
   //               |   slices  texture           a column a clock: D/F disparities
   //               |    best    |                of all passes so far
   //               |   refinement                uniqueness, subpixel
   //               |    /              .
   //           winners               2           two rows: one is made in the last pass, one leaves
   //           check                 3 or none   also from the slices: the other image's winners of two rows
   //           map                   11, 1, none median or register; or PostProcessor::kClocks
   //               |
   //           a disparity                       once in F clocks
#define STEREO_BLOCKS(BLOCK, BESIDE, PORTS)                            \
   PORTS(settings, SettingsBlock)                                      \
   BLOCK(transform, Optional<C.has_transform(), Transform<kFront<C>>>) \
   BLOCK(raster, Raster<kFront<C>>)                                    \
   BLOCK(delay, PairDelay<kFront<C>>)                                  \
   BLOCK(rows, LineBuffer<kFront<C>>)                                  \
   BLOCK(passes, RowPasses<C>)                                         \
   BESIDE(slices, Lanes)                                               \
   BESIDE(best, RowBest<C>)                                            \
   BESIDE(texture, Optional<C.has_texture_check(), TextureBlock>)      \
   BESIDE(refinement, Refinement<C>)                                   \
   BLOCK(winners, RowWinners<C>)                                       \
   BLOCK(check, Optional<C.has_left_right_check(), RowCheck<C>>)       \
   BLOCK(map, MapBlock)
   STEREO_CORE(STEREO_BLOCKS);
#undef STEREO_BLOCKS

   static constexpr Schedule kSchedule = [] {
      Schedule schedule = raster_schedule(C, C.output_width_px(), kBlocks.all().clocks, kBlocks.all().lag_groups + 1,
                                          gap_of(C, C.gap_groups()));
      schedule.clocks_per_group = C.clocks_per_pixel;
      return schedule;
   }();
   static_assert(RowPasses<C>::kClocksToShow + Lanes::kClocks + RowBest<C>::kClocks + Refinement<C>::kClocks + 2 <=
                     C.clocks_to_pass_result(),
                 "the bound in Config is too low");
   static_assert(!C.run_time_settings || kBlocks.before(map_number).clocks < C.clocks_to_last_check(),
                 "the bound in Config is too low");

   /// What the registers show in this clock. Does not depend on this clock's input.
   HLS_INLINE auto output() const { return shown(shown_group()); }

   /// The clock edge. Last block first: each reads what the block before it held until now.
   HLS_INLINE void clock(const CoreInput<C>& in) {
      if constexpr (C.has_post_processing()) map.clock(checked(), FixedSize<C>(), settings);
      else if constexpr (C.median) map.clock(checked(), FixedSize<C>());
      else if constexpr (kHasMapBlock) map.clock(checked());
      if constexpr (C.has_left_right_check()) check.clock(slices.last(), winners, settings);
      winners.clock(refinement.output(best, texture), passes);
      refinement.clock(best, texture, settings);
      best.clock(slices.last());
      if constexpr (C.has_texture_check()) texture.clock(passes, settings);
      slices.clock(passes.search, passes.reference, passes.tag, NoRival<kLanes<C>>(), settings);
      passes.clock(rows);
      rows.clock(delay);
      delay.clock(raster);
      if constexpr (C.has_transform()) {
         raster.clock(transform.output());
         transform.clock(in);
      } else {
         raster.clock(grey_values<kFront<C>>(in));
      }
   }

   /// The same where the configuration has run-time settings. `now`: what the ports show.
   HLS_INLINE void clock(const CoreInput<C>& in, const Settings& now) {
      clock(in);
      if constexpr (C.run_time_settings) settings.clock(in, now);
   }

  private:
   HLS_INLINE const Winners<C>& checked() const {
      if constexpr (C.has_left_right_check()) return check.checked;
      else return winners.winners;
   }

   HLS_INLINE MapGroup<C> shown_group() const {
      if constexpr (C.has_post_processing()) return map.group();
      else if constexpr (kHasMapBlock) return map.out;
      else return map_group<C>(checked());
   }
};

}  // namespace stereo::block_matching
