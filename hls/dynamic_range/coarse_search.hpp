// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <type_traits>

#include "block_matching/core.hpp"
#include "dynamic_range/config.hpp"
#include "phase_correlation/core.hpp"
#include "support/memory_bank.hpp"
#include "support/pixel_bits.hpp"

namespace stereo::dynamic_range {

/// The memories of a core from number `First` on, for a core that counts its own from 0.
template <class Source, int First>
struct MemoriesFrom {
   Source& source;

   template <class Word, int Depth, int Number>
   HLS_INLINE Word (&words())[Depth] {
      return source.template words<Word, Depth, First + Number>();
   }
};

template <const Config& C>
struct CoarseCoreOf {
   static auto pick() {
      if constexpr (C.codes == Codes::phase) return std::type_identity<phase_correlation::Core<kCoarseConfig<C>>>();
      else return std::type_identity<block_matching::Core<kCoarseConfig<C>>>();
   }
   using Type = typename decltype(pick())::type;
};

/// The search of the whole range in the coarse images: a core of another family. It moves with coarse pixels.
template <const Config& C>
struct CoarseSearch {
   using Core = typename CoarseCoreOf<C>::Type;
   static constexpr int kMemories = Core::kBlocks.all().memories;
   static_assert(Core::kSchedule.gap_groups == 0, "coarse frames follow each other as the frames do");

   Core core;

   template <class Source, int First>
   HLS_INLINE CoarseSearch(Source& memories, MemoryId<First>) : CoarseSearch(MemoriesFrom<Source, First>{memories}) {}

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      core.registers(visit);
   }

   HLS_INLINE StereoOutput output() const { return core.output(); }
   HLS_INLINE void clock(const CoreInput<C>& in) { core.clock(in); }

  private:
   template <class Memories>
   HLS_INLINE explicit CoarseSearch(Memories memories) : core(memories) {}
};

}  // namespace stereo::dynamic_range
