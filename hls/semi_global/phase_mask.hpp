// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <type_traits>

#include "cost/costs.hpp"
#include "frontend/image_size.hpp"
#include "semi_global/phases.hpp"
#include "support/settings.hpp"

namespace stereo::semi_global {

/// The part of the range that the frame's settings let be searched.
struct SearchedPart {
   uint8_t first, last;
};

/// With full_width: which disparities of a phase lead to a column of the other image's map, and are searched. What
/// CandidateMask is for all disparities at once. Turned: of rows that come from their last column to their first.
/// Stage: where the answers are.
template <const Config& C, bool Turned, int Stage>
struct PhaseMask {
   static constexpr int kLanes = Stages<C>::kLanes;
   static constexpr bool kFalls = C.reference == Reference::right;  ///< lane 0 has the phase's highest disparity
   static constexpr int kWidth = C.output_width_px();
   /// The other column that a row's first column meets in lane 0 of phase 0.
   static constexpr int kFarEnd = C.min_disparity + (kFalls ? C.disparities - 1 : 0);
   static constexpr int kStart = kFalls == Turned ? -kFarEnd : kFarEnd;
   /// Other columns are counted from below all that there can be: the tool shifts no negative number.
   static constexpr int kOrigin = [] {
      const int range = C.min_disparity < 0 ? -C.min_disparity : C.min_disparity;
      return 1 << bits_for(C.width_px + range + 2 * C.disparities);
   }();
   static constexpr uint16_t kPartnerMask = uint16_t(4 * kOrigin - 1);
   static constexpr uint8_t kFirstBase = kFalls ? C.disparities - 1 : 0;
   static constexpr bool kIsSet = C.run_time_settings;
   static constexpr bool kLeavesOut = kIsSet || !kWindowConfig<C>.searches_all();
   static constexpr uint8_t kLast = uint8_t(kWindowConfig<C>.last_searched());

   [[no_unique_address]] typename OfWidth<kWindowConfig<C>, kWidth>::Type width;
   [[no_unique_address]] std::conditional_t<kIsSet, SearchedPart, NoSettings> part;
   uint16_t column;  ///< of the map
   // a clock before the answers
   uint16_t partner;  ///< the other column that lane 0 meets, and kOrigin
   uint8_t base;      ///< its disparity
   // the answers
   bool inside[kLanes], searched[kLanes];

   HLS_INLINE PhaseMask() { start(*this); }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      if constexpr (C.run_time_size) visit("width", width);
      if constexpr (kIsSet) visit("first", part.first, C.first_disparity);
      if constexpr (kIsSet) visit("last", part.last, kLast);
      visit("column", column);
      visit("partner", partner);
      if constexpr (kLeavesOut) visit("base", base);
      visit("inside", inside);
      if constexpr (kLeavesOut) visit("searched", searched);
   }

   HLS_INLINE bool is_searched(int lane) const { return kLeavesOut ? searched[lane] : true; }
   HLS_INLINE bool has_candidate(int lane) const { return inside[lane] & is_searched(lane); }

   template <class Line, class Settings, class Size>
   HLS_INLINE void clock(const Line& line, const Settings& settings, const Size& size) {
      HLS_UNROLL
      for (int l = 0; l < kLanes; ++l) {
         const unsigned end = unsigned(kOrigin + width.get());
         const unsigned first = Turned ? kOrigin - l : kOrigin + l;
         inside[l] = (partner >= first) & (partner < (Turned ? end - l : end + l));
      }
      if constexpr (kLeavesOut) {
         HLS_UNROLL
         for (int l = 0; l < kLanes; ++l) {
            const uint8_t d = uint8_t(kFalls ? base - l : base + l);
            if constexpr (kIsSet) searched[l] = (d >= part.first) & (d <= part.last);
            else searched[l] = (int(d) >= C.first_disparity) & (d <= kLast);
         }
      }
      const bool comes = line.template is_there<Stage - 2>();
      const auto& place = line.template at<Stage - 2>();
      if constexpr (kIsSet) {
         const bool starts = comes & starts_frame(place);
         part.first = select<uint8_t>(starts, settings.first_disparity, part.first);
         part.last = select<uint8_t>(starts, settings.last_disparity, part.last);
      }
      const uint16_t here = select<uint16_t>(starts_row(place), 0, uint16_t(column + 1));
      const uint16_t beside = Turned ? uint16_t(partner + kLanes) : uint16_t(partner - kLanes);
      partner = select<uint16_t>(comes, uint16_t(here + (kOrigin + kStart)), beside) & kPartnerMask;
      base = select<uint8_t>(comes, kFirstBase, uint8_t(kFalls ? base - kLanes : base + kLanes));
      column = at_most<C.width_px - 1>(select<uint16_t>(comes, here, column));
      width.clock(size);
   }

  private:
   template <class Place>
   static HLS_INLINE bool starts_row(const Place& place) {
      if constexpr (Turned) return place.shown.first_column;
      else return place.first_column;
   }
   template <class Place>
   static HLS_INLINE bool starts_frame(const Place& place) {
      if constexpr (Turned) return place.shown.output_column & place.shown.start_of_frame;
      else return place.first_column & place.top;
   }
};

}  // namespace stereo::semi_global
