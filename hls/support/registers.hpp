// SPDX-License-Identifier: Apache-2.0
// Each block lists its registers once, in the order in which data flows through them:
//
//    template <class Visitor>
//    HLS_INLINE void registers(Visitor& visit) {
//       visit("column", column);          // a register, an array of registers, or a record that has such a list itself
//       visit("remainder", remainder, 1); // the last argument: what it starts with when that is not 0
//       visit.block("window", window);    // a block inside this one whose registers make a group of their own
//    }
//
// Starting values, the names in the VHDL and the traces all follow from these lists. Memories are no registers.
#pragma once

#include <type_traits>

#include "support/hls_support.hpp"

namespace stereo {

/// The visitor that gives registers their first value. Records with a constructor and inner blocks start by themselves.
/// A record that stands in arrays must have none: clang would call it in a loop of its own, which stays a loop where
/// the array is large.
struct StartingValues {
   template <class T>
   HLS_INLINE void operator()(const char*, T& value) {
      set(value, 0);
   }
   template <class T>
   HLS_INLINE void operator()(const char*, T& value, int first) {
      set(value, first);
   }
   template <class Block>
   HLS_INLINE void block(const char*, Block&, int = -1) {}

  private:
   template <class T>
   static HLS_INLINE void set(T& value, int first) {
      if constexpr (std::is_array_v<T>) {
         HLS_UNROLL
         for (int i = 0; i < int(std::extent_v<T>); ++i) set(value[i], first);
      } else if constexpr (!std::is_class_v<T>) {
         value = T(first);
      } else if constexpr (std::is_trivially_default_constructible_v<T>) {
         StartingValues values;
         value.registers(values);
      }
   }
};

/// What the constructor of a block does.
template <class Block>
HLS_INLINE void start(Block& block) {
   StartingValues values;
   block.registers(values);
}

}  // namespace stereo
