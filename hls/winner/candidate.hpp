// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "support/matching_options.hpp"
#include "support/registers.hpp"

namespace stereo {

/// What a candidate carries, and who wins.
struct CandidateKind {
   int largest_cost;  ///< costs are 0 ... largest_cost
   Ties ties = Ties::smallest;
   bool has_neighbours = false;  ///< the costs beside the winner
   bool has_second = false;      ///< the smallest cost that is not the winner's or beside it
};

/// The kind that the checks of a configuration need.
template <const auto& C>
inline constexpr CandidateKind kCandidateKind{.largest_cost = C.largest_window_cost(),
                                              .ties = C.ties,
                                              .has_neighbours = C.subpixel,
                                              .has_second = C.has_uniqueness_check()};

/// The best of a range of neighbouring disparities, and what the checks after the winner need of the others. Members
/// that the kind does not have stay 0 and cost nothing.
template <CandidateKind Kind>
struct Candidate {
   using Value = uint_of_bits<bits_for(Kind.largest_cost)>;
   static constexpr bool kHasNeighbours = Kind.has_neighbours;
   static constexpr bool kHasSecond = Kind.has_second;
   /// Larger than every cost, or as large as the type can hold.
   static constexpr Value kNone = Value((uint64_t(1) << bits_for(Kind.largest_cost + 1)) - 1);

   Value cost = 0;
   uint8_t index = 0;
   Value below = 0, above = 0;         ///< costs beside the winner; without meaning at an end of the whole range
   Value first = 0, last = 0;          ///< costs at the ends of the range
   Value second = 0;                   ///< smallest cost that is not the winner's or beside it
   Value but_first = 0, but_last = 0;  ///< smallest cost of the range without its first, last disparity

   static HLS_INLINE Candidate single(Value cost, uint8_t index) {
      Candidate candidate;
      candidate.cost = candidate.first = candidate.last = cost;
      candidate.index = index;
      candidate.second = candidate.but_first = candidate.but_last = kNone;
      return candidate;
   }

   /// Whether the cost of a higher range wins against that of a lower one.
   static HLS_INLINE bool wins(Value higher, Value lower) {
      return Kind.ties == Ties::smallest ? higher < lower : higher <= lower;
   }

   /// Joins two neighbouring ranges: a.index <= a_last < b_first <= b.index.
   static HLS_INLINE Candidate joined(const Candidate& a, int a_last, const Candidate& b, int b_first) {
      const bool b_wins = wins(b.cost, a.cost);
      Candidate best;
      best.cost = select<Value>(b_wins, b.cost, a.cost);
      best.index = select<uint8_t>(b_wins, b.index, a.index);
      const bool at_a_end = a.index == a_last, at_b_start = b.index == b_first;
      if constexpr (kHasNeighbours) {
         best.below = select<Value>(b_wins, select<Value>(at_b_start, a.last, b.below), a.below);
         best.above = select<Value>(b_wins, b.above, select<Value>(at_a_end, b.first, a.above));
         best.first = a.first;
         best.last = b.last;
      }
      if constexpr (kHasSecond) {
         const Value beside_a = smaller(a.second, select<Value>(at_a_end, b.but_first, b.cost));
         const Value beside_b = smaller(b.second, select<Value>(at_b_start, a.but_last, a.cost));
         best.second = select<Value>(b_wins, beside_b, beside_a);
         best.but_first = smaller(a.but_first, b.cost);
         best.but_last = smaller(a.cost, b.but_last);
      }
      return best;
   }

  private:
   static HLS_INLINE Value smaller(Value x, Value y) { return select<Value>(y < x, y, x); }
};

/// The candidate of a configuration's windows.
template <const auto& C>
using WindowCandidate = Candidate<kCandidateKind<C>>;

}  // namespace stereo
