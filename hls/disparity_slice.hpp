// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "diagonal_minimum.hpp"
#include "winner_tree.hpp"

namespace stereo {

/// The slices for the last `Disparities` disparities that the searched pixels meet. Each slice holds the shift, cost,
/// window and winner blocks of up to C.slice_disparities disparities and works one clock behind the slice before it,
/// from which it gets the pixels and the best candidate so far. The first slice has the highest disparities where the
/// reference is the right image, the lowest where it is the left one.
template <const StereoConfig& C, int Disparities>
struct DisparitySlice {
   static constexpr int kPixels = C.pixels_per_clock;
   static constexpr int kTaps = C.tap_rows();
   static constexpr bool kFalls = C.reference == Reference::right;
   /// A rest of one disparity joins the slice before it: a tree compares at least two.
   static constexpr int kCount = Disparities <= C.slice_disparities + 1 ? Disparities : C.slice_disparities;
   static constexpr int kRest = Disparities - kCount;
   static constexpr int kFirst = kFalls ? kRest : C.disparities - Disparities;  ///< lowest disparity here
   static constexpr bool kIsLast = kRest == 0;
   static constexpr bool kIsNone = false;
   using Next = DisparitySlice<C, kRest>;
   using Column = ColumnBlock<C, kCount>;
   using Window = WindowBlock<C, kCount>;
   static constexpr int kLevels = winner_levels(C.largest_slice(), C.winner_group);
   static constexpr int kMemories = memory_numbers::kSlices + memory_numbers::kPerSlice * kFirst;

   /// Clocks from the pixels' arrival at this slice to the best candidate of all slices.
   static constexpr int latency() {
      if constexpr (kIsLast) return 1 + Column::kClocks + Window::kClocks + kLevels + 1;
      else return 1 + Next::latency();
   }

   DisparityShift<C, kCount> shift;
   Column cost;
   Window window;
   DiagonalMinimum<C, (C.has_left_right_check() ? kCount : 1)> other;
   WinnerTree<C, kCount, kLevels> winner;
   Candidates<C, 1> best;  ///< of this slice and those before it; its index is the disparity
   PixelTag best_tag;
   Next next;

   template <class Source>
   HLS_INLINE explicit DisparitySlice(Source& memories)
       : cost(memories, MemoryId<kMemories + memory_numbers::kColumns>()),
         window(memories, MemoryId<kMemories + memory_numbers::kLastColumns>()),
         next(memories) {}

   /// `rival`: the slice before this one, or NoRival.
   template <class Rival>
   HLS_INLINE void clock(const Feature<C> (&search)[kTaps], const Feature<C> (&reference)[kTaps], const PixelTag& tag,
                         const Rival& rival) {
      next.clock(shift.search_out, shift.reference, shift.tag, *this);
      const auto& root = winner.root();
      HLS_UNROLL
      for (int p = 0; p < kPixels; ++p) {
         Candidate<C> here = root.best.get(p, 0);
         here.index = uint8_t(kFirst + here.index);
         best.set(p, 0, against(here, rival, p));
      }
      best_tag = root.tag;
      winner.clock(window.sum, window.tag);
      if constexpr (C.has_left_right_check()) other.clock(window.sum, window.tag, kFirst, rival.other);
      window.clock(cost);
      cost.clock(shift);
      shift.clock(search, reference, tag);
   }

   HLS_INLINE const auto& last() const {
      if constexpr (kIsLast) return *this;
      else return next.last();
   }

  private:
   template <class Rival>
   static HLS_INLINE Candidate<C> against(const Candidate<C>& here, const Rival& rival, int p) {
      if constexpr (Rival::kIsNone) return here;
      else if constexpr (kFalls)
         return Candidate<C>::joined(here, kFirst + kCount - 1, rival.best.get(p, 0), kFirst + kCount);
      else return Candidate<C>::joined(rival.best.get(p, 0), kFirst - 1, here, kFirst);
   }
};

/// Stands before the first slice.
template <const StereoConfig& C>
struct NoRival {
   static constexpr bool kIsNone = true;
   NoDiagonal<C> other;
};

/// Behind the last slice there are no disparities left.
template <const StereoConfig& C>
struct DisparitySlice<C, 0> {
   template <class Source>
   HLS_INLINE explicit DisparitySlice(Source&) {}
   template <class Rival>
   HLS_INLINE void clock(const Feature<C> (&)[C.tap_rows()], const Feature<C> (&)[C.tap_rows()], const PixelTag&,
                         const Rival&) {}
};

}  // namespace stereo
