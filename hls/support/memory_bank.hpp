// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "support/hls_support.hpp"

namespace stereo {

/// Names one of a core's memories. Numbers are handed down: a block with memories is given its first number, takes
/// kMemories numbers from there on, and gives its inner blocks theirs.
template <int Number>
struct MemoryId {};

/// `Count` memories of `Depth` words, read together at one address and written together at another.
///
/// The words stand outside the core: a memory that is indexed at run time would tie every register of the same object
/// to memory. They come from a `Source`, an object with `template <class Word, int Depth, int Number> Word
/// (&words())[Depth]`, that gives each number its own array of zeros.
template <class Word, int Depth, int Count>
struct MemoryBank {
   static constexpr int kMemories = Count;

   Word (&words)[Depth];
   MemoryBank<Word, Depth, Count - 1> others;

   template <class Source, int First>
   HLS_INLINE MemoryBank(Source& source, MemoryId<First> first)
       : words(source.template words<Word, Depth, First + Count - 1>()), others(source, first) {}

   template <int N>
   HLS_INLINE void read(uint16_t address, Word (&out)[N]) const {
      out[Count - 1] = words[address];
      others.read(address, out);
   }
   /// Each memory at its own address.
   template <int N>
   HLS_INLINE void read_each(const uint16_t (&addresses)[N], Word (&out)[N]) const {
      out[Count - 1] = words[addresses[Count - 1]];
      others.read_each(addresses, out);
   }
   template <int N>
   HLS_INLINE void write(uint16_t address, const Word (&in)[N]) {
      words[address] = in[Count - 1];
      others.write(address, in);
   }
   /// Each memory at its own address.
   template <int N>
   HLS_INLINE void write_each(const uint16_t (&addresses)[N], const Word (&in)[N]) {
      words[addresses[Count - 1]] = in[Count - 1];
      others.write_each(addresses, in);
   }
};

template <class Word, int Depth>
struct MemoryBank<Word, Depth, 0> {
   static constexpr int kMemories = 0;

   template <class Source, int First>
   HLS_INLINE MemoryBank(Source&, MemoryId<First>) {}
   template <int N>
   HLS_INLINE void read(uint16_t, Word (&)[N]) const {}
   template <int N>
   HLS_INLINE void read_each(const uint16_t (&)[N], Word (&)[N]) const {}
   template <int N>
   HLS_INLINE void write(uint16_t, const Word (&)[N]) {}
   template <int N>
   HLS_INLINE void write_each(const uint16_t (&)[N], const Word (&)[N]) {}
};

}  // namespace stereo
