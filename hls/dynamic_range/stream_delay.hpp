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
   static constexpr int kMostGroups = Config::kMostMemoryBits / (8 * int(sizeof(Data))) - 1;
   static constexpr int kClocks = (Groups + kMostGroups - 1) / kMostGroups;
   static constexpr int kLagGroups = Groups;
   /// Of the first ring; the others hold the rest.
   static constexpr int kHere = (Groups + kClocks - 1) / kClocks;
   using Datas = Ring<Data, kHere + 1, 1>;
   using Starts = Ring<uint8_t, kHere + 1, 1>;
   using Next = typename std::conditional_t<(kClocks > 1), std::type_identity<StreamDelay<Bits, Groups - kHere>>,
                                            std::type_identity<Absent>>::type;
   static constexpr int kMemories = Datas::kMemories + Starts::kMemories + Next::kMemories;

   Datas datas;
   Starts starts;
   bool holds_groups;  ///< a reset leaves the words of the rings, with their starts of frames, as they were
   Data held[1];
   uint8_t held_start[1];
   bool held_is_new;
   bool held_valid;
   Next next;

   template <class Source, int First>
   HLS_INLINE StreamDelay(Source& memories, MemoryId<First> first)
       : datas(memories, first),
         starts(memories, MemoryId<First + Datas::kMemories>()),
         next(memories, MemoryId<First + Datas::kMemories + Starts::kMemories>()) {
      start(*this);
   }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("datas", datas);
      visit("starts", starts);
      visit("holds_groups", holds_groups);
      visit("held", held);
      visit("held_start", held_start);
      visit("held_is_new", held_is_new);
      visit("held_valid", held_valid);
      if constexpr (kClocks > 1) visit("next", next);
   }

   HLS_INLINE Data data() const {
      if constexpr (kClocks > 1) return next.data();
      else return held[0];
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
      if constexpr (kClocks > 1) next.clock(held[0], starts_here(), held_valid);
      const bool is_new = holds_groups | (datas.read_address == 0);  // place 0 is the first that is written
      const Data data_words[1] = {data_in};
      const uint8_t start_words[1] = {uint8_t(start_in)};
      datas.clock(data_words, valid_in, held);
      starts.clock(start_words, valid_in, held_start);
      held_is_new = is_new;
      holds_groups = select<bool>(valid_in, is_new, holds_groups);
      held_valid = valid_in;
   }

  private:
   HLS_INLINE bool starts_here() const { return held_is_new & ((held_start[0] & 1) != 0); }
};

}  // namespace stereo::dynamic_range
