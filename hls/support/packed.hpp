// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "support/hls_support.hpp"

namespace stereo {

/// Bits of the words of a memory that has so many, `wished` where it can: of a memory of more than 100,000 bits the
/// tool makes another cell, which the lowering does not know.
constexpr int word_bits_of(int words, int wished) {
   return wished == 8 || words * wished <= 100'000 ? wished : word_bits_of(words, wished / 2);
}

/// `Lanes` numbers of `LaneBits` side by side in as few words of at most `WordBits` bits as hold them, or one to a word
/// where they are wider, lane 0 in the lowest bits of word 0: how numbers that share an address share a memory. (The
/// front end cuts registers of more than 32 bits into pieces.)
template <int LaneBits, int Lanes, int WordBits = 32>
struct Packed {
   static_assert(LaneBits >= 1 && LaneBits <= 64, "a lane has 1 ... 64 bits");
   static constexpr int kFitting = LaneBits <= WordBits ? WordBits / LaneBits : 1;
   static constexpr int kPerWord = kFitting < Lanes ? kFitting : Lanes;
   static constexpr int kWords = (Lanes + kPerWord - 1) / kPerWord;
   using Lane = uint_of_bits<LaneBits>;
   using Word = uint_of_bits<LaneBits * kPerWord>;

   static HLS_INLINE Lane lane(const Word (&words)[kWords], int index) {
      return Lane(words[index / kPerWord] >> (LaneBits * (index % kPerWord))) & kMask;
   }

   static HLS_INLINE void pack(const Lane (&lanes)[Lanes], Word (&words)[kWords]) {
      HLS_UNROLL
      for (int w = 0; w < kWords; ++w) {
         Word word = 0;
         HLS_UNROLL
         for (int i = 0; i < kPerWord; ++i)
            if (w * kPerWord + i < Lanes) word |= Word(Word(lanes[w * kPerWord + i]) << (LaneBits * i));
         words[w] = word;
      }
   }

  private:
   static constexpr Lane kMask = Lane(Lane(~Lane(0)) >> (8 * int(sizeof(Lane)) - LaneBits));
};

}  // namespace stereo
