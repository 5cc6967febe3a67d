// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "semi_global/path_sums.hpp"
#include "trellis/forward.hpp"
#include "winner/candidate.hpp"
#include "winner/winner_tree.hpp"

namespace stereo::trellis {

/// The state in which a row ends: the smallest d with the smallest E of its last column. It stands in `state` kClocks
/// clocks behind the move that makes E, and until the next row ends.
template <const Config& C>
struct LastState {
   static constexpr int kCount = C.disparities;
   static constexpr int kLevels = winner_levels(kCount, C.winner_group);
   static constexpr int kClocks = kLevels + 2;
   static constexpr int kBits = C.path_bits();
   using Value = PathValue<C>;
   using Best = Candidate<CandidateKind{.largest_cost = (1 << kBits) - 1}>;
   using Tags = semi_global::TagMoves<Forward<C>::kMoves>;
   /// The row behind is traced back from its first column on; the last one of this row has come so many columns before.
   static_assert(Forward<C>::kMoves + kClocks <= kCostConfig<C>.turn_columns() + 1, "the state must be there in time");

   Tags tags;
   // clock 1: above the smallest number that any can have
   Value path[1][kCount];
   PixelTag tag;
   WinnerTree<Best, PixelTag, 1, C.winner_group, kCount, kLevels> winner;
   uint8_t state;

   HLS_INLINE LastState() { start(*this); }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("tags", tags);
      visit("path", path);
      visit("tag", tag);
      winner.levels(visit);
      visit("state", state);
   }

   HLS_INLINE void clock(const semi_global::PathEntry<kCostConfig<C>>& entry, const Forward<C>& forward) {
      constexpr Value kHalf = Value(uint64_t(1) << (kBits - 1)), kMask = Value((uint64_t(1) << kBits) - 1);
      const auto& best = winner.root();
      const bool ends = best.tag.valid && best.tag.map_column && best.tag.end_of_line;
      state = select<uint8_t>(ends, best.best.get(0, 0).index, state);
      winner.clock(path, tag);
      HLS_UNROLL
      for (int d = 0; d < kCount; ++d) path[0][d] = Value(forward.path[d] - forward.path[0] + kHalf) & kMask;
      tag = tags.out();
      tags.clock(entry.tag.valid, entry.tag);
   }
};

}  // namespace stereo::trellis
