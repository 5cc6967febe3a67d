// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "block_matching/disparity_slice.hpp"
#include "frontend/image_size.hpp"
#include "frontend/line_buffer.hpp"
#include "frontend/pair_delay.hpp"
#include "frontend/raster.hpp"
#include "phase_correlation/config.hpp"
#include "phase_correlation/phase_distance.hpp"
#include "phase_correlation/phase_transform.hpp"
#include "phase_correlation/settings.hpp"
#include "postprocessing/post_processor.hpp"
#include "support/blocks.hpp"
#include "support/optional_block.hpp"
#include "support/pixel_bits.hpp"
#include "support/schedule.hpp"
#include "winner/left_right_check.hpp"
#include "winner/map_group.hpp"
#include "winner/median.hpp"
#include "winner/refinement.hpp"

namespace stereo::phase_correlation {

/// The phase-correlation core: one call of `clock` is one clock of the hardware. docs/algorithm.md defines the result.
///
/// Input: W*H records a frame, any number of bubbles between them. Output: map width * H records. A row leaves while
/// the rows below it come in; after the last row of a frame come the first rows of the next one, or
/// kSchedule.flush_groups pairs of any valid pixels without start of frame. There is no back-pressure: a record a clock
/// is always taken.
template <const Config& C>
struct Core {
   static_assert(kCanBeBuilt<C>);
   static constexpr const Config& kConfig = C;
   using Matching = phase_correlation::Matching;
   static constexpr const auto& kCodes = kCodeConfig<C>;

   using Slices = block_matching::DisparitySlice<kCodeConfig<C>>;
   using Refine = Refinement<kCodeConfig<C>>;
   /// What makes the map of the winners. Whole disparities without a median are ready as they are.
   using MapBlock = std::conditional_t<
       C.has_post_processing(), PostProcessor<kCodeConfig<C>>,
       std::conditional_t<C.median, Median<kCodeConfig<C>>, Optional<C.subpixel, MapRegister<kCodeConfig<C>>>>>;
   static constexpr bool kHasMapBlock = C.median || C.subpixel || C.has_post_processing();
   using Settings =
       std::conditional_t<C.run_time_size, SizedSettings<phase_correlation::Settings>, phase_correlation::Settings>;
   using SettingsBlock = std::conditional_t<C.run_time_settings, FrameSettings<C>, NoSettings>;
   using Size = std::conditional_t<C.run_time_size, RunTimeSize<kCodeConfig<C>>, FixedSize<kCodeConfig<C>>>;

   //            a pixel pair
   //                 |
   //   clocks   transform                 PhaseTransform::kClocks: phase codes
   //            raster                    1           place in the frame
   //            delay                     1           the reference meets what it is compared with
   //            rows                      3           columns of all rows of the windows
   //            slices                    Slices::kClocks: phase differences, local weighting, peak
   //            refinement                0, 4, 12    uniqueness, subpixel
   //            leftright                 4 or none   also from the slices, ahead of the refinement
   //            map                       11, 1, none median or register; or PostProcessor::kClocks
   //                 |
   //            a disparity
   // Phase codes have no texture to check.
#define STEREO_BLOCKS(BLOCK, BESIDE, PORTS)                                                                     \
   PORTS(settings, SettingsBlock)                                                                               \
   PORTS(size, Size)                                                                                            \
   BLOCK(transform, PhaseTransform<kCodeConfig<C>>)                                                             \
   BLOCK(raster, Raster<kCodeConfig<C>>)                                                                        \
   BLOCK(delay, PairDelay<kCodeConfig<C>>)                                                                      \
   BLOCK(rows, LineBuffer<kCodeConfig<C>>)                                                                      \
   BLOCK(slices, Slices)                                                                                        \
   BESIDE(texture, Absent)                                                                                      \
   BLOCK(refinement, Refine)                                                                                    \
   BLOCK(leftright,                                                                                             \
         Optional<C.has_left_right_check(), LeftRightCheck<kCodeConfig<C>, Slices::kLevels + Refine::kClocks>>) \
   BLOCK(map, MapBlock)
   STEREO_CORE(STEREO_BLOCKS);
#undef STEREO_BLOCKS

   static constexpr Schedule kSchedule = window_schedule(C, kCodes, kBlocks.all());
   static_assert(!C.run_time_settings || kBlocks.before(map_number).clocks < kCodes.clocks_to_last_check(),
                 "the bound in Config is too low");

   /// What the registers show in this clock. Does not depend on this clock's input.
   HLS_INLINE auto output() const { return shown(shown_group()); }

   /// The clock edge. Last block first: each reads what the block before it held until now.
   HLS_INLINE void clock(const CoreInput<C>& in) {
      if constexpr (C.has_post_processing()) map.clock(checked(), size, settings);
      else if constexpr (C.median) map.clock(checked(), size);
      else if constexpr (kHasMapBlock) map.clock(checked());
      if constexpr (C.has_left_right_check()) check();
      refinement.clock(slices.last(), texture, settings);
      slices.clock(rows.search, rows.reference, rows.tag, block_matching::NoRival<kCodeConfig<C>>(), settings, size);
      rows.clock(delay);
      delay.clock(raster, size);
      raster.clock(transform.output(), size);
      transform.clock(in, size);
   }

   /// The same where the configuration has run-time settings or a run-time size. `now`: what the ports show. Thresholds
   /// count in the clock of a start of frame; the size is that of all frames from one reset to the next.
   HLS_INLINE void clock(const CoreInput<C>& in, const Settings& now) {
      clock(in);
      if constexpr (C.run_time_settings) settings.clock(in, now);
      if constexpr (C.run_time_size) size.clock(now.image_width, now.image_height);
   }

  private:
   HLS_INLINE void check() {
      const auto& other = slices.last().other;
      const uint8_t other_winner[1] = {other.winner[0][other.kOldest]};
      leftright.clock(refinement.output(slices.last(), texture), other_winner, settings);
   }

   HLS_INLINE Winners<kCodeConfig<C>> checked() const {
      if constexpr (C.has_left_right_check()) return leftright.checked;
      else return refinement.output(slices.last(), texture);
   }

   HLS_INLINE MapGroup<kCodeConfig<C>> shown_group() const {
      if constexpr (C.has_post_processing()) return map.group();
      else if constexpr (kHasMapBlock) return map.out;
      else return map_group<kCodeConfig<C>>(checked());
   }
};

}  // namespace stereo::phase_correlation
