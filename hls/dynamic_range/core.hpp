// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dynamic_range/block_ranges.hpp"
#include "dynamic_range/centre_base.hpp"
#include "dynamic_range/coarse_pixels.hpp"
#include "dynamic_range/coarse_search.hpp"
#include "dynamic_range/compared_rows.hpp"
#include "dynamic_range/config.hpp"
#include "dynamic_range/search_rows.hpp"
#include "dynamic_range/search_window.hpp"
#include "dynamic_range/shown_map.hpp"
#include "dynamic_range/stream_delay.hpp"
#include "dynamic_range/track_choice.hpp"
#include "dynamic_range/window_bases.hpp"
#include "dynamic_range/window_targets.hpp"
#include "frontend/pair_delay.hpp"
#include "frontend/raster.hpp"
#include "frontend/transform.hpp"
#include "phase_correlation/phase_distance.hpp"
#include "phase_correlation/phase_transform.hpp"
#include "postprocessing/post_processor.hpp"
#include "support/blocks.hpp"
#include "support/optional_block.hpp"
#include "support/pixel_bits.hpp"
#include "support/schedule.hpp"
#include "winner/refinement.hpp"

namespace stereo::dynamic_range {

/// When things happen between the coarse images and the search windows, in groups from the start of a frame on.
template <const Config& C>
struct Timing {
   using Coarse = typename CoarseSearch<C>::Core;
   static constexpr int kCoarseWidth = kCoarseConfig<C>.width_px;

   /// The group that brings the coarse core its group number `n`.
   static constexpr int arrival(int n) {
      const int row = n / kCoarseWidth, column = n % kCoarseWidth, side = Config::kCoarse;
      const int last = C.coarse_columns() - 1;
      return (side * row + side - 1) * C.width_px +
             (column <= last ? side * column + side - 1 : C.width_px - 1 + column - last);
   }
   /// The same for what brings the last pixel of a row of the coarse map.
   static constexpr int row_of_map(int row) {
      return arrival(Coarse::kSchedule.groups_to_first_output - 1 + row * kCoarseWidth + C.coarse_columns() - 1);
   }
   /// From there to the targets: as many clocks, and at most as many groups.
   static constexpr int kClocks = CoarsePixels<C>::kClocks + Coarse::kSchedule.latency_clocks + 2 + C.coarse_columns() +
                                  2 + BlockRanges<C>::kClocks + WindowTargets<C>::kClocks;
   /// The targets of a frame's first band: they need the row of blocks below it, and that the row of the map below
   /// that.
   static constexpr int kFirstTargets = row_of_map(2 * Config::kBlock / Config::kCoarse) + kClocks;
   /// Rows from a frame's end to its last coarse group: until then, no other frame may start.
   static constexpr int kGapRows =
       (row_of_map(C.coarse_rows() - 1) + 1 - C.height_px * C.width_px + C.width_px - 1) / C.width_px;
};

/// The core with a dynamic range: one call of `clock` is one clock of the hardware. docs/algorithm.md defines the
/// result.
///
/// Input: W*H records a frame, any number of bubbles between them. Output: map width * H records, some 45 rows later:
/// the images are held back until it is known where the search windows go. After the last row of a frame come
/// kSchedule.gap_groups pairs of any valid pixels without start of frame, then the next frame, or
/// kSchedule.flush_groups. There is no back-pressure: a record a clock is always taken.
template <const Config& C>
struct Core {
   static_assert(kCanBeBuilt<C>);
   static constexpr const Config& kConfig = C;
   using Matching = dynamic_range::Matching;
   static constexpr const auto& kWindow = kWindowConfig<C>;

   using Transform = std::conditional_t<C.codes == Codes::phase, phase_correlation::PhaseTransform<kWindowConfig<C>>,
                                        stereo::Transform<kWindowConfig<C>>>;
   using Bases = WindowBases<C>;
   using Rows = SearchRows<C, kWindowConfig<C>>;
   using Window = SearchWindow<C, kWindowConfig<C>>;
   using Pairs = PairDelay<kWindowConfig<C>>;
   using Compared =
       ComparedRows<C, kWindowConfig<C>, Bases::kClocks + Rows::kClocks + Window::Chain::kClocks - Pairs::kClocks>;
   using Centre = CentreBase<C, Rows::kClocks + Window::kClocks>;
   using Refine = Refinement<kWindowConfig<C>>;

   static constexpr int kHeldBack = Timing<C>::kFirstTargets - Transform::kLagGroups - C.ahead_groups();
   static_assert(kHeldBack > 0);
   using HoldBack = StreamDelay<2 * kPixelBits<C>, kHeldBack>;

   //            a pixel pair
   //                 |
   //   clocks   coarse_pixels             5           means of 4x4 pixels, at their rate from here on
   //            coarse                                a core that searches the whole range
   //            ranges                    9           surfaces of each block of 8x8 pixels
   //            targets                               where the search windows should begin
   //                                                  beside it:
   //            hold_back                 1 or more   some 45 rows
   //            transform                             codes
   //            ahead                     1           the whole range of searched codes comes first
   //            raster                    1           place in the frame
   //            bases                     5           where the search windows stand
   //            rows                      5           the codes that they take in
   //            low, high                             costs, sums and winners of the two search windows
   //            choice                    1           the better one
   //            refinement                0 or 12     subpixel
   //            map                       1
   //            post                      PostProcessor::kClocks or none
   //                 |
   //            a disparity
#define STEREO_BLOCKS(BLOCK, BESIDE, PORTS)                            \
   BESIDE(coarse_pixels, CoarsePixels<C>)                              \
   BESIDE(coarse, CoarseSearch<C>)                                     \
   BESIDE(ranges, BlockRanges<C>)                                      \
   BESIDE(targets, WindowTargets<C>)                                   \
   BLOCK(hold_back, HoldBack)                                          \
   BLOCK(transform, Transform)                                         \
   BLOCK(ahead, StreamDelay<kWindow.feature_bits(), C.ahead_groups()>) \
   BLOCK(raster, Raster<kWindowConfig<C>>)                             \
   BLOCK(bases, Bases)                                                 \
   BLOCK(rows, Rows)                                                   \
   BESIDE(pairs, Pairs)                                                \
   BESIDE(compared, Compared)                                          \
   BLOCK(low, Window)                                                  \
   BESIDE(high, Window)                                                \
   BESIDE(centre, Centre)                                              \
   BLOCK(choice, TrackChoice<C, kWindowConfig<C>>)                     \
   BLOCK(refinement, Refine)                                           \
   BLOCK(map, ShownMap<C, kWindowConfig<C>, Refine::kClocks>)          \
   BLOCK(post, Optional<C.has_map_block(), PostProcessor<kMapConfig<C>>>)
   STEREO_CORE(STEREO_BLOCKS);
#undef STEREO_BLOCKS

   /// The windows wait for the rows below them, too; and until a frame's last coarse group no other one may start.
   static constexpr Schedule kSchedule = [] {
      BlockSums sums = kBlocks.all();
      sums.lag_groups += kWindow.delay_groups() * C.width_px;
      Schedule schedule = window_schedule(C, kWindow, sums);
      const int coarse_gap = Timing<C>::kGapRows * C.width_px;
      if (schedule.gap_groups < coarse_gap) schedule.gap_groups = coarse_gap;
      return schedule;
   }();

   /// What the registers show in this clock. Does not depend on this clock's input.
   HLS_INLINE auto output() const {
      if constexpr (C.has_map_block()) return shown(post.group());
      else return shown(map.map);
   }

   /// The clock edge. Last block first: each reads what the block before it held until now.
   HLS_INLINE void clock(const CoreInput<C>& in) {
      if constexpr (C.has_map_block()) post.clock(map.map, FixedSize<kWindowConfig<C>>());
      map.clock(refinement, choice);
      refinement.clock(choice, NoTexture());
      const auto &low_root = low.winner.root(), &high_root = high.winner.root();
      choice.clock(low_root.best.get(0, 0), high_root.best.get(0, 0), low_root.tag, centre.base(kLow),
                   centre.base(kHigh));
      centre.clock(bases);
      const Seen seen = compared_now();
      low.clock(rows, kLow, seen, compared.early_tag().valid);
      high.clock(rows, kHigh, seen, compared.early_tag().valid);
      compared.clock(pairs);
      pairs.clock(raster);
      const FeatureGroup<kWindowConfig<C>> newest = transform.output();
      rows.clock(newest, bases);
      bases.clock(raster.features.valid, raster.place, targets);
      raster.clock(behind());
      ahead.clock(newest.reference[0], newest.start_of_frame, newest.valid);
      transform.clock(held_back());
      hold_back.clock(typename HoldBack::Data(in.left[0] | in.right[0] << kPixelBits<C>), in.start_of_frame, in.valid);
      targets.clock(ranges);
      ranges.clock(coarse.output());
      coarse.clock(coarse_pixels.out);
      coarse_pixels.clock(in);
   }

  private:
   struct NoTexture {};
   struct Seen {
      Feature<kWindowConfig<C>> reference[2];
      bool inside[2];
      PixelTag tag;
   };

   HLS_INLINE Seen compared_now() const {
      Seen seen;
      HLS_UNROLL
      for (int tap = 0; tap < 2; ++tap) {
         seen.reference[tap] = compared.shown().reference[tap];
         seen.inside[tap] = compared.shown().inside[tap];
      }
      seen.tag = compared.tag();
      return seen;
   }

   HLS_INLINE CoreInput<C> held_back() const {
      CoreInput<C> in;
      in.left[0] = pixel_of<C>(hold_back.data(), 0);
      in.right[0] = pixel_of<C>(hold_back.data(), 1);
      in.start_of_frame = hold_back.start_of_frame();
      in.valid = hold_back.valid();
      return in;
   }

   HLS_INLINE FeatureGroup<kWindowConfig<C>> behind() const {
      FeatureGroup<kWindowConfig<C>> group;
      group.reference[0] = ahead.data();
      group.start_of_frame = ahead.start_of_frame();
      group.valid = ahead.valid();
      return group;
   }
};

}  // namespace stereo::dynamic_range
