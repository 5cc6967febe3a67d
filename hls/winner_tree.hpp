// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hls_support.hpp"
#include "stream.hpp"

namespace stereo {

/// Winner-take-all tree: the smallest of N costs and the smallest index that has it. One clock a level; each level
/// reduces groups of `Group` candidates to one, ceil(log_Group N) levels.
template <int N, int Group>
struct WinnerTree {
   static_assert(N > 1 && Group >= 2, "a tree compares at least two candidates");
   static constexpr int kWinners = (N + Group - 1) / Group;
   static constexpr int kLevels = 1 + WinnerTree<kWinners, Group>::kLevels;

   uint16_t cost[kWinners];
   uint8_t index[kWinners];
   PixelTag tag;
   WinnerTree<kWinners, Group> next;

   inline WinnerTree() {
      fill<uint16_t>(cost, 0);
      fill<uint8_t>(index, 0);
   }

   /// First level: the candidates' indices are their places.
   inline void clock(const uint16_t (&candidate)[N], PixelTag in) {
      uint8_t place[N];
      HLS_UNROLL
      for (int i = 0; i < N; ++i) place[i] = uint8_t(i);
      clock(candidate, place, in);
   }

   inline void clock(const uint16_t (&candidate)[N], const uint8_t (&place)[N], PixelTag in) {
      next.clock(cost, index, tag);
      HLS_UNROLL
      for (int group = 0; group < kWinners; ++group) {
         uint16_t best = candidate[group * Group];
         uint8_t winner = place[group * Group];
         HLS_UNROLL
         for (int i = group * Group + 1; i < (group + 1) * Group && i < N; ++i) {
            const bool smaller = candidate[i] < best;  // strictly: the smaller index wins a tie
            best = select<uint16_t>(smaller, candidate[i], best);
            winner = select<uint8_t>(smaller, place[i], winner);
         }
         cost[group] = best;
         index[group] = winner;
      }
      tag = in;
   }

   inline uint8_t winner() const {
      if constexpr (kWinners == 1) return index[0];
      else return next.winner();
   }
   inline PixelTag winner_tag() const {
      if constexpr (kWinners == 1) return tag;
      else return next.winner_tag();
   }
};

/// Below the last level there is nothing left to compare.
template <int Group>
struct WinnerTree<1, Group> {
   static constexpr int kLevels = 0;
   inline void clock(const uint16_t (&)[1], const uint8_t (&)[1], PixelTag) {}
};

}  // namespace stereo
