// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "support/hls_support.hpp"

namespace stereo {

/// `Lanes` numbers of `LaneBits` side by side in words of `WordBits` bits, without a bit between them, lane 0 in the
/// lowest bits of word 0. A lane may stand in two words. For deep memories, of which each bit counts; Packed is the
/// simpler one.
template <int LaneBits, int Lanes, int WordBits>
struct DensePacked {
   static_assert(WordBits == 8 || WordBits == 16, "a word fills its type and is a number to the lowering");
   static_assert(LaneBits >= 1 && LaneBits <= WordBits, "a lane has as many bits as a word at most");
   static constexpr int kWords = (Lanes * LaneBits + WordBits - 1) / WordBits;
   using Lane = uint_of_bits<LaneBits>;
   using Word = uint_of_bits<WordBits>;

   static HLS_INLINE Lane lane(const Word (&words)[kWords], int index) {
      const int word = LaneBits * index / WordBits, start = LaneBits * index % WordBits;
      Lane lane = Lane(words[word] >> start);
      if (start + LaneBits > WordBits)
         lane = Lane(lane | Lane(words[word + 1 < kWords ? word + 1 : word] << (WordBits - start)));
      return Lane(lane & kMask);
   }

   /// No lane has bits above its LaneBits.
   static HLS_INLINE void pack(const Lane (&lanes)[Lanes], Word (&words)[kWords]) {
      HLS_UNROLL
      for (int w = 0; w < kWords; ++w) {
         Word word = 0;
         HLS_UNROLL
         for (int i = 0; i < Lanes; ++i) {
            const int start = LaneBits * i - WordBits * w;  // in this word; below 0: it begins in the word before
            if (start >= 0 && start < WordBits) word |= Word(Word(lanes[i]) << start);
            if (start < 0 && start > -LaneBits) word |= Word(lanes[i] >> -start);
         }
         words[w] = word;
      }
   }

  private:
   static constexpr Lane kMask = Lane(Lane(~Lane(0)) >> (8 * int(sizeof(Lane)) - LaneBits));
};

}  // namespace stereo
