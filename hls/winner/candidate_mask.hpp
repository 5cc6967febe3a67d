// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <type_traits>

#include "cost/costs.hpp"
#include "frontend/image_size.hpp"
#include "frontend/pixel_tag.hpp"
#include "support/matching_options.hpp"
#include "support/registers.hpp"
#include "support/settings.hpp"

namespace stereo {

/// Which of `Count` disparities the frame's settings let be searched.
template <int Count>
struct SearchedHere {
   bool disparity[Count];
};

/// With full_width: which of `Count` disparities lead to a column of the other image whose window lies in the image,
/// for the centres of the windows whose sums are shown. The answers move on with the columns of the other image, as its
/// pixels do; at a row's first column they are constants, so that nothing of the row before is left. In step with the
/// window sums. Registers: Count + 1 bits, and in the first block the bits of a column; with run-time settings Count
/// bits more, which say what the frame's settings let be searched.
///
/// Blocks are chained as the shifts are: the next one takes `left_out` one clock later. First: the lowest disparity
/// here.
template <const auto& C, int Count, int First>
struct CandidateMask {
   static constexpr bool kFalls = C.reference == Reference::right;
   static constexpr int kNewest = kFalls ? Count - 1 : 0;  ///< where a column of the other image enters
   static constexpr int kOldest = Count - 1 - kNewest;     ///< and where it leaves
   static constexpr int kWidth = C.output_width_px();
   static constexpr bool kIsFirst = First + kNewest == (kFalls ? C.disparities - 1 : 0);
   using End = typename OfWidth<C, kWidth - (kFalls ? 1 : -1) * (C.min_disparity + First + kNewest) - 1>::Type;
   using NoEnd = FixedNumber<0>;

   bool inside[Count];                                                  ///< [i]: of disparity First + i
   bool left_out;                                                       ///< of the column that has just left
   uint16_t column;                                                     ///< of the centre
   [[no_unique_address]] std::conditional_t<kIsFirst, End, NoEnd> end;  ///< from this `column` on, none enters
   [[no_unique_address]] std::conditional_t<kSetAtRunTime<C>, SearchedHere<Count>, NoSettings> searched;

   HLS_INLINE CandidateMask() { start(*this); }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("inside", inside);
      visit("left_out", left_out);
      if constexpr (kIsFirst) visit("column", column);
      if constexpr (kIsFirst && kRunTimeSize<C>) visit("end", end);
      if constexpr (kSetAtRunTime<C>) visit("searched", searched.disparity, 1);
   }

   /// centre: the tag of the centres that come now; before: the block before this one, or NoMask.
   template <class Before, class Settings = NoSettings, class Size = FixedSize<C>>
   HLS_INLINE void clock(const PixelTag& centre, const Before& before, const Settings& settings = Settings(),
                         const Size& size = Size()) {
      if constexpr (kSetAtRunTime<C>) take_over(centre, settings);
      const bool move = centre.valid;
      const bool starts = centre.first_column;
      const bool entering = enters(before);
      left_out = inside[kOldest];
      HLS_UNROLL
      for (int step = 0; step < Count; ++step) {
         const int i = kFalls ? step : Count - 1 - step;
         const int from = i == kNewest ? i : kFalls ? i + 1 : i - 1;
         const bool moved = i == kNewest ? entering : inside[from];
         const bool at_start = at(0, First + i) >= 0 && at(0, First + i) < kWidth;
         inside[i] = select<bool>(move, select<bool>(starts, at_start, moved), inside[i]);
      }
      if constexpr (kIsFirst) {
         const uint16_t next = select<uint16_t>(starts, 0, uint16_t(column + 1));
         column = at_most<C.width_px - 1>(select<uint16_t>(move, next, column));
         end.clock(size);
      }
   }

   /// Whether disparity First + i leads to a column that counts, and is searched.
   HLS_INLINE bool has_candidate(int i) const {
      if constexpr (kSetAtRunTime<C>) return inside[i] & searched.disparity[i];
      else if constexpr (C.searches_all()) return inside[i];
      else return inside[i] & (First + i >= C.first_disparity) & (First + i <= C.last_searched());
   }

   /// Whether disparity First + i is searched, wherever it leads.
   HLS_INLINE bool is_searched(int i) const {
      if constexpr (kSetAtRunTime<C>) return searched.disparity[i];
      else if constexpr (C.searches_all()) return true;
      else return (First + i >= C.first_disparity) & (First + i <= C.last_searched());
   }
   /// The costs that are compared where all that is searched is a candidate.
   template <int kPixels>
   HLS_INLINE void hide_unsearched(const WindowCost<C> (&sum)[kPixels][Count],
                                   WindowCost<C> (&shown)[kPixels][Count]) const {
      HLS_UNROLL
      for (int p = 0; p < kPixels; ++p) {
         HLS_UNROLL
         for (int i = 0; i < Count; ++i)
            shown[p][i] = WindowCost<C>(sum[p][i] | select<WindowCost<C>>(is_searched(i), 0, kMaskedCost<C>));
      }
   }

   /// The costs that are compared: those of candidates, and one above all of them where there is none. There,
   /// remembered signs are those of other pixels, and the sum may have higher bits than any cost.
   template <int kPixels>
   HLS_INLINE void hide(const WindowCost<C> (&sum)[kPixels][Count], WindowCost<C> (&shown)[kPixels][Count]) const {
      HLS_UNROLL
      for (int p = 0; p < kPixels; ++p) {
         HLS_UNROLL
         for (int i = 0; i < Count; ++i) {
            shown[p][i] = WindowCost<C>(sum[p][i] | select<WindowCost<C>>(has_candidate(i), 0, kMaskedCost<C>));
            if constexpr (kRemembersSigns) shown[p][i] = WindowCost<C>(shown[p][i] & kMaskedCost<C>);
         }
      }
   }

  private:
   static constexpr bool kRemembersSigns = [] {
      if constexpr (requires { C.remembers_signs(); }) return C.remembers_signs();
      else return false;
   }();

   template <class Settings>
   HLS_INLINE void take_over(const PixelTag& centre, const Settings& settings) {
      const bool now = is_first_of_frame(centre);
      HLS_UNROLL
      for (int i = 0; i < Count; ++i) {
         const bool is_searched =
             (First + i >= int(settings.first_disparity)) & (First + i <= int(settings.last_disparity));
         searched.disparity[i] = select<bool>(now, is_searched, searched.disparity[i]);
      }
   }

   /// The column of the map at which the other image's pixel stands, for a column of the map and a disparity.
   static constexpr int at(int map_column, int d) {
      return kFalls ? map_column + C.min_disparity + d : map_column - C.min_disparity - d;
   }

   /// Of the column that enters beside the centre in the column behind `column`.
   template <class Before>
   HLS_INLINE bool enters(const Before& before) const {
      if constexpr (kIsFirst) {
         const int shift = at(1, First + kNewest);  // from `column` on
         return (int(column) >= -shift) & (int(column) < end.get());
      } else {
         return before.left_out;
      }
   }
};

/// Stands before the first block.
struct NoMask {};

}  // namespace stereo
