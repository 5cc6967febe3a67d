// SPDX-License-Identifier: Apache-2.0
// A core lists its blocks once, in data-flow order:
//
//    #define STEREO_BLOCKS(BLOCK, BESIDE, PORTS)
//       PORTS(size, Size)
//       BLOCK(transform, Optional<C.has_transform(), Transform<C>>)
//       BLOCK(rows, LineBuffer<C>)
//       BLOCK(slices, DisparitySlice<C>)
//       BESIDE(texture, Texture<C>)
//
// A BLOCK stands in the way from pixels to disparities; a BESIDE works beside it; PORTS are settings that come from
// ports, and take no room where they do not. STEREO_CORE(STEREO_BLOCKS), within the core, makes a member of each, the
// constructor, `registers`, and `kBlocks`: the sums of what blocks say of themselves.
#pragma once

#include <type_traits>

#include "support/memory_bank.hpp"

namespace stereo {

/// What a block says of itself, as far as it does.
struct BlockSums {
   int clocks = 0;      ///< from what it takes to what it gives
   int lag_groups = 0;  ///< valid groups of pixels that it holds back
   int memories = 0;

   template <class Block>
   static constexpr BlockSums beside() {
      BlockSums sums;
      if constexpr (requires { Block::kMemories; }) sums.memories = Block::kMemories;
      return sums;
   }
   template <class Block>
   static constexpr BlockSums in_the_way() {
      BlockSums sums = beside<Block>();
      if constexpr (requires { Block::kClocks; }) sums.clocks = Block::kClocks;
      if constexpr (requires { Block::kLagGroups; }) sums.lag_groups = Block::kLagGroups;
      return sums;
   }
};

/// Of the blocks of a core.
template <int Count>
struct BlockList {
   BlockSums block[Count];

   /// All blocks before number `end`.
   constexpr BlockSums before(int end) const {
      BlockSums sums;
      for (int i = 0; i < end; ++i) {
         sums.clocks += block[i].clocks;
         sums.lag_groups += block[i].lag_groups;
         sums.memories += block[i].memories;
      }
      return sums;
   }
   constexpr BlockSums all() const { return before(Count); }
};

/// A block as a member of a core: with its memories from number `First` on, where it has some.
template <class Block>
struct Member : Block {
   template <class Source, int First>
      requires std::is_constructible_v<Block, Source&, MemoryId<First>>
   HLS_INLINE Member(Source& core_memories, MemoryId<First> first_memory) : Block(core_memories, first_memory) {}
   template <class Source, int First>
   HLS_INLINE Member(Source&, MemoryId<First>) {}
};

/// Ends the list of members in a constructor.
struct EndOfBlocks {};

/// Lists the registers of a block under its name, or under names of its own groups; nothing where it has none.
template <class Visitor, class Block>
HLS_INLINE void visit_block(Visitor& visit, const char* name, Block& block) {
   if constexpr (requires { block.groups(visit); }) block.groups(visit);
   else if constexpr (requires { block.registers(visit); }) visit.block(name, block);
}

#define STEREO_BLOCK_NUMBER(name, ...) name##_number,
#define STEREO_BLOCK_IN_THE_WAY(name, ...) BlockSums::in_the_way<__VA_ARGS__>(),
#define STEREO_BLOCK_BESIDE(name, ...) BlockSums::beside<__VA_ARGS__>(),
#define STEREO_BLOCK_MEMBER(name, ...) Member<__VA_ARGS__> name;
#define STEREO_PORTS_MEMBER(name, ...) [[no_unique_address]] Member<__VA_ARGS__> name;
#define STEREO_BLOCK_BUILT(name, ...) name(memories, MemoryId<kBlocks.before(name##_number).memories>()),
#define STEREO_BLOCK_VISIT(name, ...) visit_block(visit, #name, name);

// clang-format off
/// `memories`: see MemoryBank.
#define STEREO_CORE(BLOCKS)                                                                          \
   enum BlockNumber { BLOCKS(STEREO_BLOCK_NUMBER, STEREO_BLOCK_NUMBER, STEREO_BLOCK_NUMBER) block_count };\
   static constexpr BlockList<block_count> kBlocks = {                                               \
       {BLOCKS(STEREO_BLOCK_IN_THE_WAY, STEREO_BLOCK_BESIDE, STEREO_BLOCK_BESIDE)}};                 \
   BLOCKS(STEREO_BLOCK_MEMBER, STEREO_BLOCK_MEMBER, STEREO_PORTS_MEMBER)                             \
   [[no_unique_address]] EndOfBlocks end;                                                            \
                                                                                                     \
   template <class Source>                                                                           \
   HLS_INLINE explicit Core(Source& memories)                                                        \
       : BLOCKS(STEREO_BLOCK_BUILT, STEREO_BLOCK_BUILT, STEREO_BLOCK_BUILT) end() {}                 \
                                                                                                     \
   template <class Visitor>                                                                          \
   HLS_INLINE void registers(Visitor& visit) {                                                       \
      BLOCKS(STEREO_BLOCK_VISIT, STEREO_BLOCK_VISIT, STEREO_BLOCK_VISIT)                             \
   }                                                                                                 \
   static_assert(true, "for the semicolon")
// clang-format on

}  // namespace stereo
