// SPDX-License-Identifier: Apache-2.0
// With F clocks a pixel pair its D disparities come in F phases of L = D/F lanes, one a clock. docs/semi_global.md
// draws it.
#pragma once

#include <type_traits>

#include "semi_global/config.hpp"
#include "support/dense_packed.hpp"
#include "support/minimum_tree.hpp"
#include "support/packed.hpp"
#include "winner/winner_tree.hpp"

namespace stereo::semi_global {

/// The clocks in which a column's phase 0 is somewhere, counted from its costs; phase p is there p clocks later.
template <const Config& C>
struct Stages {
   static constexpr int kPhases = C.clocks_per_pixel;
   static constexpr int kLanes = C.phase_disparities();
   static constexpr int kLevels = MinimumTree<uint8_t, kLanes>::kLevels;
   static constexpr int kWindows = -1;  ///< window costs
   static constexpr int kCosts = 0;     ///< those that the paths see
   /// The costs again, when the smallest of all phases is known.
   static constexpr int kPaths = kPhases + kLevels + 1;
   static constexpr int kPathCosts = kPaths + 2;  ///< K of all paths
   static constexpr int kSums = kPathCosts + 1;
   static constexpr int kWinnerLevels = winner_levels(kLanes, C.winner_group);
   static constexpr int kWinners = kSums + kWinnerLevels;  ///< the best of a phase
   static constexpr int kBest = kWinners + kPhases;        ///< that of all phases is there for one clock
   /// The smallest K of all phases: later than the best where the winners' tree has fewer levels than that of the
   /// minimum.
   static constexpr int kLow = kPathCosts + kLevels + kPhases;
   static constexpr int kEnd = kBest > kLow ? kBest : kLow + 1;
};

/// Bits of the words of a deep memory. Words of 32 bits are no numbers to the lowering.
constexpr int deep_word_bits(int words) { return word_bits_of(words, 16); }

/// How the numbers of a phase stand in a memory of so many words.
template <int LaneBits, int Lanes, int Words>
using DeepPacked =
    typename std::conditional_t<(LaneBits <= deep_word_bits(Words)),
                                std::type_identity<DensePacked<LaneBits, Lanes, deep_word_bits(Words)>>,
                                std::type_identity<Packed<LaneBits, Lanes, deep_word_bits(Words)>>>::type;

/// What has no bubbles.
struct AlwaysMoves {
   static HLS_INLINE constexpr bool lane(int) { return true; }
};

/// The phase of a column. `starts`: in the clock before its phase 0. At rest it stays at the last phase.
template <int Phases>
struct PhaseCount {
   uint16_t phase;

   HLS_INLINE PhaseCount() { start(*this); }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("phase", phase, Phases - 1);
   }

   HLS_INLINE bool is_first() const { return phase == 0; }
   HLS_INLINE bool is_last() const { return phase == Phases - 1; }
   /// Whether the next clock has a phase.
   HLS_INLINE bool moves(bool starts) const { return starts | (!is_last()); }
   HLS_INLINE void clock(bool starts) {
      const uint16_t beside = select<uint16_t>(is_last(), phase, uint16_t(phase + 1));
      phase = at_most<Phases - 1>(select<uint16_t>(starts, 0, beside));
   }
};

/// Address of a phase in a memory that has the phases of a column side by side. At rest it stays where it was.
template <int Phases, int Words>
struct PhaseAddress {
   uint16_t address;
   bool is_here;  ///< this clock has a phase
   PhaseCount<Phases> count;

   HLS_INLINE PhaseAddress() { start(*this); }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("address", address);
      visit("is_here", is_here);
      visit("count", count);
   }

   /// base: the address of the column that starts.
   HLS_INLINE void clock(bool starts, uint16_t base) {
      const uint16_t next = select<uint16_t>(starts, base, uint16_t(address + 1));
      is_here = count.moves(starts);
      address = at_most<Words - 1>(select<uint16_t>(count.moves(starts), next, address));
      count.clock(starts);
   }
   /// Columns of a row one after the other. first: the column that starts is the row's first.
   HLS_INLINE void go_on(bool starts, bool first) { clock(starts, select<uint16_t>(first, 0, uint16_t(address + 1))); }
};

/// The smallest number of all phases, of so many bits. `starts`: the number of phase 0 is there. It replaces what is
/// compared and not the comparison's result, of which the tool would make a table, bit by bit.
template <int Bits, class Value>
HLS_INLINE Value smallest_so_far(bool starts, Value now, Value before) {
   constexpr Value kNone = Value((uint64_t(1) << Bits) - 1);
   return smaller_of<Value>(select<Value>(starts, kNone, before), now);
}

}  // namespace stereo::semi_global
