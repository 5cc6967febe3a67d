// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "support/registers.hpp"
#include "support/ring.hpp"

namespace stereo::dynamic_range {

/// Holds a stream back by `Groups` groups: `Bits` bits of each, and whether a frame starts with it. 1 clock. Memory:
/// (Groups + 1) x (Bits + 1) bits; the start of a frame has one of its own, as the tool takes memories of 100 kB at
/// most in words of whole bytes.
template <int Bits, int Groups>
struct StreamDelay {
   static constexpr int kClocks = 1;
   static constexpr int kLagGroups = Groups;
   using Data = uint_of_bits<Bits>;
   using Delay = Ring<Data, Groups + 1, 2>;
   static constexpr int kMemories = Delay::kMemories;

   Delay ring;
   bool holds_groups;  ///< a reset leaves the words of the ring, with their starts of frames, as they were
   Data held[2];       ///< data, start of frame
   bool held_is_new;
   bool valid;

   template <class Source, int First>
   HLS_INLINE StreamDelay(Source& memories, MemoryId<First> first) : ring(memories, first) {
      start(*this);
   }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("ring", ring);
      visit("holds_groups", holds_groups);
      visit("held", held);
      visit("held_is_new", held_is_new);
      visit("valid", valid);
   }

   HLS_INLINE Data data() const { return held[0]; }
   HLS_INLINE bool start_of_frame() const { return held_is_new & ((held[1] & 1) != 0); }

   HLS_INLINE void clock(Data data_in, bool start_in, bool valid_in) {
      const bool is_new = holds_groups | (ring.read_address == 0);  // place 0 is the first that is written
      const Data words[2] = {data_in, Data(start_in)};
      ring.clock(words, valid_in, held);
      held_is_new = is_new;
      holds_groups = select<bool>(valid_in, is_new, holds_groups);
      valid = valid_in;
   }
};

}  // namespace stereo::dynamic_range
