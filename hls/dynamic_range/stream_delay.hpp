// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <type_traits>

#include "dynamic_range/config.hpp"
#include "support/optional_block.hpp"
#include "support/registers.hpp"
#include "support/ring.hpp"

namespace stereo::dynamic_range {

/// Holds a stream back by `Groups` groups: `Bits` bits of each, and whether a frame starts with it. As many rings, one
/// behind the other, as the tool's limit for one memory asks for; a clock each. Memory: (Groups + kClocks) x (Bits + 1)
/// bits.
template <int Bits, int Groups>
struct StreamDelay {
   using Data = uint_of_bits<Bits>;
   using Word = uint_of_bits<Bits + 1>;
   static constexpr int kMostGroups = Config::kMostMemoryBits / (8 * int(sizeof(Word))) - 1;
   static constexpr int kClocks = (Groups + kMostGroups - 1) / kMostGroups;
   static constexpr int kLagGroups = Groups;
   /// Of the first ring; the others hold the rest.
   static constexpr int kHere = (Groups + kClocks - 1) / kClocks;
   using Delay = Ring<Word, kHere + 1, 1>;
   using Next = typename std::conditional_t<(kClocks > 1), std::type_identity<StreamDelay<Bits, Groups - kHere>>,
                                            std::type_identity<Absent>>::type;
   static constexpr int kMemories = Delay::kMemories + Next::kMemories;

   Delay ring;
   bool holds_groups;  ///< a reset leaves the words of the rings, with their starts of frames, as they were
   Word held[1];
   bool held_is_new;
   bool held_valid;
   Next next;

   template <class Source, int First>
   HLS_INLINE StreamDelay(Source& memories, MemoryId<First> first)
       : ring(memories, first), next(memories, MemoryId<First + Delay::kMemories>()) {
      start(*this);
   }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("ring", ring);
      visit("holds_groups", holds_groups);
      visit("held", held);
      visit("held_is_new", held_is_new);
      visit("held_valid", held_valid);
      if constexpr (kClocks > 1) visit("next", next);
   }

   HLS_INLINE Data data() const {
      if constexpr (kClocks > 1) return next.data();
      else return data_here();
   }
   HLS_INLINE bool start_of_frame() const {
      if constexpr (kClocks > 1) return next.start_of_frame();
      else return starts_here();
   }
   HLS_INLINE bool valid() const {
      if constexpr (kClocks > 1) return next.valid();
      else return held_valid;
   }

   HLS_INLINE void clock(Data data_in, bool start_in, bool valid_in) {
      if constexpr (kClocks > 1) next.clock(data_here(), starts_here(), held_valid);
      const bool is_new = holds_groups | (ring.read_address == 0);  // place 0 is the first that is written
      const Word words[1] = {Word(Word(data_in) << 1 | Word(start_in))};
      ring.clock(words, valid_in, held);
      held_is_new = is_new;
      holds_groups = select<bool>(valid_in, is_new, holds_groups);
      held_valid = valid_in;
   }

  private:
   HLS_INLINE Data data_here() const { return Data(held[0] >> 1); }
   HLS_INLINE bool starts_here() const { return held_is_new & ((held[0] & 1) != 0); }
};

}  // namespace stereo::dynamic_range
