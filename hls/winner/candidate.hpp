// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "support/full_width.hpp"
#include "support/matching_options.hpp"
#include "support/registers.hpp"
#include "winner/winners.hpp"

namespace stereo {

/// What a candidate carries, and who wins.
struct CandidateKind {
   int largest_cost;  ///< costs are 0 ... largest_cost
   Ties ties = Ties::smallest;
   bool has_neighbours = false;  ///< the costs beside the winner
   bool has_second = false;      ///< the smallest cost that is not the winner's or beside it
   bool has_masked = false;      ///< there are costs of no candidate: a number above the largest cost
};

/// The kind that the checks of a configuration need.
template <const auto& C>
inline constexpr CandidateKind kCandidateKind{.largest_cost = C.largest_window_cost(),
                                              .ties = C.ties,
                                              .has_neighbours = C.subpixel,
                                              .has_second = C.has_uniqueness_check() || kHasMargin<C>,
                                              .has_masked = kFullWidth<C>};

template <CandidateKind Kind>
struct Losers;

/// The best of a range of neighbouring disparities, and the costs beside it. Members that the kind does not have stay 0
/// and cost nothing.
template <CandidateKind Kind>
struct Candidate {
   static constexpr int kBits = bits_for(Kind.largest_cost + (Kind.has_masked ? 1 : 0));
   using Value = uint_of_bits<kBits>;
   using Others = Losers<Kind>;
   static constexpr bool kHasNeighbours = Kind.has_neighbours;
   static constexpr bool kHasSecond = Kind.has_second;

   Value cost = 0;
   uint8_t index = 0;
   Value below = 0, above = 0;  ///< costs beside the winner; without meaning at an end of the whole range
   Value first = 0, last = 0;   ///< costs at the ends of the range

   static HLS_INLINE Candidate single(Value cost, uint8_t index) {
      Candidate candidate;
      candidate.cost = candidate.first = candidate.last = cost;
      candidate.index = index;
      return candidate;
   }

   /// Whether the cost of a higher range wins against that of a lower one.
   template <class Cost>
   static HLS_INLINE bool wins(Cost higher, Cost lower) {
      return Kind.ties == Ties::smallest ? higher < lower : higher <= lower;
   }

   /// Joins two neighbouring ranges: a.index <= a_last < b_first <= b.index.
   static HLS_INLINE Candidate joined(const Candidate& a, int a_last, const Candidate& b, int b_first) {
      const bool b_wins = wins(b.cost, a.cost);
      Candidate best;
      best.cost = select<Value>(b_wins, b.cost, a.cost);
      best.index = select<uint8_t>(b_wins, b.index, a.index);
      if constexpr (kHasNeighbours) {
         best.below = select<Value>(b_wins, select<Value>(b.index == b_first, a.last, b.below), a.below);
         best.above = select<Value>(b_wins, b.above, select<Value>(a.index == a_last, b.first, a.above));
         best.first = a.first;
         best.last = b.last;
      }
      return best;
   }
};

/// Which of some neighbouring ranges holds the winner.
struct Choice {
   uint8_t place = 0;      ///< 0, 1, ...
   bool at_start = false;  ///< the winner is the first disparity of its range, and there is a range before it
   bool at_end = false;    ///< the last one, and there is a range behind it

   static HLS_INLINE Choice of(uint8_t place, bool at_start, bool at_end) {
      Choice choice;
      choice.place = place;
      choice.at_start = at_start;
      choice.at_end = at_end;
      return choice;
   }
   static HLS_INLINE Choice chosen(bool upper, const Choice& a, const Choice& b) {
      return of(select<uint8_t>(upper, b.place, a.place), select<bool>(upper, b.at_start, a.at_start),
                select<bool>(upper, b.at_end, a.at_end));
   }
};

/// The costs of a range that do not win, which the uniqueness check needs: known a clock after the candidate, so that a
/// registered choice and one comparison make them.
template <CandidateKind Kind>
struct Losers {
   using Value = typename Candidate<Kind>::Value;
   /// Larger than every cost, or as large as the type can hold.
   static constexpr Value kNone = Value((uint64_t(1) << bits_for(Kind.largest_cost + 1)) - 1);

   Value cost = 0;                             ///< the winner's
   Value second = kNone;                       ///< smallest cost that is not the winner's or beside it
   Value but_first = kNone, but_last = kNone;  ///< smallest cost of the range without its first, last disparity

   static HLS_INLINE Losers single(Value cost) {
      Losers losers;
      losers.cost = cost;
      return losers;
   }

   /// Adds cost `I` of `Count` of neighbouring disparities of which number `place` wins. Without kNone where there are
   /// numbers: no tool knows that costs are smaller.
   template <int I, int Count>
   HLS_INLINE void add_single(Value single, int place) {
      if constexpr (I > 0) but_first = I == 1 ? single : smaller(but_first, single);
      if constexpr (I + 1 < Count) but_last = I == 0 ? single : smaller(but_last, single);
      if constexpr (Count > 2) {
         const bool is_far = (I > place + 1) | (place > I + 1);
         second = smaller(second, select<Value>(is_far, single, kNone));
      }
   }

   /// Of the range at `Place` of `Count`: without the winner of all of them and the costs beside it. In a pair, a flag
   /// alone says which of the two the winner touches.
   template <int Place, int Count>
   HLS_INLINE Losers left_by(const Choice& choice) const {
      const bool touches_last = choice.at_start & (Count == 2 ? Place == 0 : choice.place == Place + 1);
      const bool touches_first = choice.at_end & (Count == 2 ? Place == 1 : choice.place + 1 == Place);
      Losers losers = *this;
      losers.second = select<Value>(choice.place == Place, second, cost);
      losers.second = select<Value>(touches_last, but_last, losers.second);
      losers.second = select<Value>(touches_first, but_first, losers.second);
      return losers;
   }

   /// Joins two neighbouring ranges of which nothing is left that `second` must not have.
   static HLS_INLINE Losers joined(const Losers& a, const Losers& b) {
      Losers losers;
      losers.cost = smaller(a.cost, b.cost);
      losers.second = smaller(a.second, b.second);
      losers.but_first = smaller(a.but_first, b.cost);
      losers.but_last = smaller(a.cost, b.but_last);
      return losers;
   }

  private:
   static HLS_INLINE Value smaller(Value x, Value y) { return select<Value>(y < x, y, x); }
};

/// The candidate of a configuration's windows.
template <const auto& C>
using WindowCandidate = Candidate<kCandidateKind<C>>;
template <const auto& C>
using WindowLosers = Losers<kCandidateKind<C>>;

}  // namespace stereo
