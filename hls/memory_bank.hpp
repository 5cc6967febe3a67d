// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hls_support.hpp"

namespace stereo {

/// Names one of a core's memories.
template <int Number>
struct MemoryId {};

/// `Count` memories of `Depth` words, read together at one address and written together at another.
///
/// The words stand outside the core: a memory that is indexed at run time would tie every register of the same object
/// to memory. They come from a `Source`, an object with `template <class Word, int Depth, int Number> Word
/// (&words())[Depth]`, that gives each number its own array of zeros. A bank takes the numbers First ... First + Count
/// - 1.
template <class Word, int Depth, int Count>
struct MemoryBank {
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
};

template <class Word, int Depth>
struct MemoryBank<Word, Depth, 0> {
   template <class Source, int First>
   HLS_INLINE MemoryBank(Source&, MemoryId<First>) {}
   template <int N>
   HLS_INLINE void read(uint16_t, Word (&)[N]) const {}
   template <int N>
   HLS_INLINE void read_each(const uint16_t (&)[N], Word (&)[N]) const {}
   template <int N>
   HLS_INLINE void write(uint16_t, const Word (&)[N]) {}
};

/// The numbers of a core's memories, far enough apart for each bank.
namespace memory_numbers {
inline constexpr int kDelay = 0;
inline constexpr int kSearchRows = 100;
inline constexpr int kReferenceRows = 200;
inline constexpr int kLeftPixels = 300;
inline constexpr int kRightPixels = 400;
inline constexpr int kWinners = 500;
inline constexpr int kOtherWinners = 600;
inline constexpr int kMap = 700;
inline constexpr int kTexture = 800;
inline constexpr int kSlices = 2000;  ///< + 200 x lowest disparity of the slice
inline constexpr int kPerSlice = 200;
inline constexpr int kColumns = 0;        ///< of a slice or the texture: its column sums
inline constexpr int kLastColumns = 300;  ///< of a slice or the texture: the columns of its windows
}  // namespace memory_numbers

}  // namespace stereo
