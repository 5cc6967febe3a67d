// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "frontend/pixel_tag.hpp"
#include "semi_global/path_winners.hpp"
#include "semi_global/phase_mask.hpp"
#include "semi_global/phases.hpp"
#include "winner/candidate.hpp"
#include "winner/candidates.hpp"

namespace stereo::semi_global {

/// What needs no tag: the columns' line has it.
struct NoTag {
   template <class Visitor>
   HLS_INLINE void registers(Visitor&) {}
};

/// The winner of a phase, and of all phases so far: what the checks of the winner ask of the last slice in block
/// matching. That of a column is there for one clock, its losers a clock later.
template <const Config& C>
struct PhaseWinners {
   using At = Stages<C>;
   static constexpr const auto& kSums = kSumConfig<C>;
   static constexpr int kPhases = At::kPhases;
   static constexpr int kLanes = At::kLanes;
   static constexpr int kClocks = At::kBest - At::kSums;
   /// With a right reference lane 0 has the highest disparity of all.
   static constexpr bool kFalls = C.reference == Reference::right;
   using Candidate = WindowCandidate<kSumConfig<C>>;
   using Others = WindowLosers<kSumConfig<C>>;
   using Value = WindowCost<kSumConfig<C>>;
   using Tree = WinnerBlock<At::kIsGated, Candidate, NoTag, 1, C.winner_group, kLanes, At::kWinnerLevels>;
   /// As in PathWinners.
   static constexpr bool kHides = PathWinners<C>::kHides;
   static constexpr bool kHasMask = PathWinners<C>::kHasMask;
   using Mask = std::conditional_t<kHasMask, PhaseMask<C, C.path_right, At::kSums>, NoMask>;
   using Partner = std::conditional_t<C.has_border_cost(), WinnerPartner<C>, NoPartner>;
   static constexpr int kFirstBase = kFalls ? C.disparities - kLanes : 0;

   [[no_unique_address]] Mask mask;
   Tree winner;
   uint8_t base;  ///< the lowest disparity of the phase
   bool was_first;
   Candidates<Candidate, 1, 1> best;
   PixelTag best_tag;
   [[no_unique_address]] Partner partner;

   HLS_INLINE PhaseWinners() { start(*this); }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      if constexpr (kHasMask) visit.block("mask", mask);
      winner.levels(visit);
      visit("base", base, kFirstBase);
      visit("was_first", was_first);
      visit("best", best);
      visit("best_tag", best_tag);
      if constexpr (C.has_border_cost()) visit("partner", partner);
   }

   template <class Paths, class Line, class Settings, class Size>
   HLS_INLINE void clock(const Paths& paths, const Line& line, [[maybe_unused]] const Settings& settings,
                         [[maybe_unused]] const Size& size) {
      const bool first = line.template is_there<At::kWinners>();
      if constexpr (Candidate::kHasSecond) join_losers();
      join(first);
      was_first = first;
      const uint8_t next = uint8_t(kFalls ? base - kLanes : base + kLanes);
      base = select<uint8_t>(line.template is_there<At::kWinners - 1>(), kFirstBase, next);
      tell(line);
      Value sums[1][kLanes];
      HLS_UNROLL
      for (int l = 0; l < kLanes; ++l) {
         const int lane = kFalls ? kLanes - 1 - l : l;
         sums[0][l] = paths.shown(lane);
         if constexpr (kHides) sums[0][l] |= select<Value>(is_compared(lane), 0, kMaskedCost<kSumConfig<C>>);
      }
      winner.clock(sums, NoTag());
      if constexpr (kHasMask) mask.clock(line, settings, size);
      if constexpr (C.has_border_cost()) partner.resize(size);
   }

  private:
   HLS_INLINE bool is_compared(int lane) const {
      if constexpr (C.has_border_cost()) return mask.is_searched(lane);
      else return mask.has_candidate(lane);
   }

   template <class Line>
   HLS_INLINE void tell(const Line& line) {
      const auto& place = line.template at<At::kBest - 1>().shown;
      best_tag.valid = line.template is_there<At::kBest - 1>();
      best_tag.map_column = place.map_column;
      best_tag.output_column = place.output_column;
      best_tag.first_column = place.first_column;
      best_tag.start_of_frame = place.start_of_frame;
      best_tag.end_of_line = place.end_of_line;
      if constexpr (C.has_border_cost()) partner.clock(best.index[0][0], best_tag);
   }

   /// Of two ranges, the phases before and this one, which lies above them or, if they fall, below.
   HLS_INLINE void join(bool first) {
      const Candidate before = best.get(0, 0), now = winner.root().best.get(0, 0);
      Candidate here = now;
      here.index = uint8_t(base + now.index);
      const Candidate lower = chosen(here, before), upper = chosen(before, here);
      const bool wins = Candidate::wins(upper.cost, lower.cost);
      const bool upper_wins = kFalls ? (!first) & wins : first | wins;
      bool lower_at_end, upper_at_start;
      if constexpr (kFalls) {
         lower_at_end = (!first) & (now.index == kLanes - 1);
         upper_at_start = before.index == uint8_t(base + kLanes);
      } else {
         lower_at_end = before.index == uint8_t(base - 1);
         upper_at_start = (!first) & (now.index == 0);
      }
      Candidate joined;
      joined.cost = select<Value>(upper_wins, upper.cost, lower.cost);
      joined.index = select<uint8_t>(upper_wins, upper.index, lower.index);
      if constexpr (Candidate::kHasNeighbours) {
         joined.below = select<Value>(upper_wins, select<Value>(upper_at_start, lower.last, upper.below), lower.below);
         joined.above = select<Value>(upper_wins, upper.above, select<Value>(lower_at_end, upper.first, lower.above));
         joined.first = select<Value>(first, here.first, lower.first);
         joined.last = select<Value>(first, here.last, upper.last);
      }
      best.set(0, 0, joined,
               Choice::chosen(upper_wins, Choice::of(0, false, lower_at_end), Choice::of(1, upper_at_start, false)));
   }
   static HLS_INLINE Candidate chosen(const Candidate& if_falls, const Candidate& if_rises) {
      if constexpr (kFalls) return if_falls;
      else return if_rises;
   }

   HLS_INLINE void join_losers() {
      Others before = best.losers(0, 0);
      before.cost = select<Value>(was_first, Others::kNone, before.cost);
      before.second = select<Value>(was_first, Others::kNone, before.second);
      before.but_first = select<Value>(was_first, Others::kNone, before.but_first);
      before.but_last = select<Value>(was_first, Others::kNone, before.but_last);
      const Others here = winner.root().best.losers(0, 0);
      if constexpr (kFalls) best.join_losers(0, 0, here, before);
      else best.join_losers(0, 0, before, here);
   }
};

}  // namespace stereo::semi_global
