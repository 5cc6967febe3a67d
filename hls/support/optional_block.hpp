// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <type_traits>

#include "support/memory_bank.hpp"

namespace stereo {

/// Stands for a block that a configuration does not have.
struct Absent {
   static constexpr int kClocks = 0;
   static constexpr int kLagGroups = 0;
   static constexpr int kMemories = 0;

   template <class Source, int First>
   HLS_INLINE Absent(Source&, MemoryId<First>) {}

   template <class Visitor>
   HLS_INLINE void registers(Visitor&) {}
};

/// `Block` is not looked into where it is absent.
template <bool Present, class Block>
using Optional = std::conditional_t<Present, Block, Absent>;

}  // namespace stereo
