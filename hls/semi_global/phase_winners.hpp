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
   /// Few lanes: a GatedTree saves little, and the resets of its registers come late.
   using Tree = WinnerTree<Candidate, NoTag, 1, C.winner_group, kLanes, At::kWinnerLevels>;
   /// As in PathWinners.
   static constexpr bool kHides = PathWinners<C>::kHides;
   static constexpr bool kHasMask = PathWinners<C>::kHasMask;
   using Mask = std::conditional_t<kHasMask, PhaseMask<C, C.path_right, At::kSums>, NoMask>;
   using Partner = std::conditional_t<C.has_border_cost(), WinnerPartner<C>, NoPartner>;
   /// What no phase has lost to.
   using Wide = uint_of_bits<Candidate::kBits + 1>;
   static constexpr Wide kNone = Wide((uint64_t(1) << (Candidate::kBits + 1)) - 1);

   [[no_unique_address]] Mask mask;
   Tree winner;
   bool was_first;
   Candidates<Candidate, 1, 1> best;  ///< its index counts from the phase on, so that it is right in the last one
   PixelTag best_tag;
   [[no_unique_address]] Partner partner;

   HLS_INLINE PhaseWinners() { start(*this); }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      if constexpr (kHasMask) visit.block("mask", mask);
      winner.levels(visit);
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

   /// Of two ranges, the phases before and this one, which lies above them or, if they fall, below. Where a column
   /// starts, nothing of the one before may stay: a register that costs let keep its value would be taken for one that
   /// a reset must set, and with it all that the costs follow from.
   HLS_INLINE void join(bool first) {
      constexpr int kPassed = kFalls ? 0 : C.disparities - kLanes;  // disparities of the phases before the last one
      const Candidate here = winner.root().best.get(0, 0);
      Candidate before = best.get(0, 0);
      const Wide before_cost = select<Wide>(first, kNone, before.cost);
      const bool here_wins = kFalls ? !Candidate::template wins<Wide>(before_cost, here.cost)
                                    : Candidate::template wins<Wide>(here.cost, before_cost);
      bool before_at_end, here_at_end;  // they touch each other
      before_at_end = before.index == (kFalls ? 0 : C.disparities - 1);
      here_at_end = (!first) & (here.index == (kFalls ? kLanes - 1 : 0));
      Candidate joined;
      joined.cost = Value(select<Wide>(here_wins, here.cost, before_cost));
      joined.index = select<uint8_t>(here_wins, uint8_t(here.index + kPassed),
                                     uint8_t(kFalls ? before.index + kLanes : before.index - kLanes));
      if constexpr (Candidate::kHasNeighbours) {
         clear(before.below, first);
         clear(before.above, first);
         const Candidate lower = chosen(here, before), upper = chosen(before, here);
         const bool lower_at_end = kFalls ? here_at_end : before_at_end;
         const bool upper_at_start = kFalls ? before_at_end : here_at_end;
         const bool upper_wins = here_wins != kFalls;
         joined.below = select<Value>(upper_wins, select<Value>(upper_at_start, lower.last, upper.below), lower.below);
         joined.above = select<Value>(upper_wins, upper.above, select<Value>(lower_at_end, upper.first, lower.above));
         joined.first = select<Value>(first, here.first, lower.first);
         joined.last = select<Value>(first, here.last, upper.last);
      }
      best.set(0, 0, joined,
               Choice::chosen(here_wins != kFalls, Choice::of(0, false, kFalls ? here_at_end : before_at_end),
                              Choice::of(1, kFalls ? before_at_end : here_at_end, false)));
   }
   static HLS_INLINE void clear(Value& value, bool first) { value = select<Value>(first, 0, value); }
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
