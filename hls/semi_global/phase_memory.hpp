// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "support/hls_support.hpp"
#include "support/memory_bank.hpp"
#include "support/registers.hpp"

namespace stereo::semi_global {

/// Banks of a deep memory: the first `Bank` of them whole, the last as deep as it must be.
template <class Word, int Words, int Count, int BankWords, bool IsFirst = true>
struct WordBanks {
   using Others = WordBanks<Word, Words - BankWords, Count, BankWords, false>;
   static constexpr int kMemories = Count + Others::kMemories;
   static constexpr int kBanks = 1 + Others::kBanks;
   static constexpr int kLastDepth = Others::kLastDepth;

   MemoryBank<Word, BankWords, Count> bank;
   Others others;

   template <class Source, int First>
   HLS_INLINE WordBanks(Source& source, MemoryId<First> first)
       : bank(source, first), others(source, MemoryId<First + Count>()) {}

   template <int Banks>
   HLS_INLINE void read(const uint16_t (&address)[Banks], Word (&out)[Banks][Count]) const {
      bank.read(address[Banks - kBanks], out[Banks - kBanks]);
      others.read(address, out);
   }
   template <int Banks>
   HLS_INLINE void write(const uint16_t (&address)[Banks], const Word (&in)[Banks][Count]) {
      bank.write(address[Banks - kBanks], in[Banks - kBanks]);
      others.write(address, in);
   }
};

template <class Word, int Words, int Count, int BankWords, bool IsFirst>
   requires(Words <= BankWords)
struct WordBanks<Word, Words, Count, BankWords, IsFirst> {
   static constexpr int kMemories = Count;
   static constexpr int kBanks = 1;
   /// Behind other banks a power of two, as their addresses come here, too.
   static constexpr int kLastDepth = IsFirst ? Words : 1 << bits_for(Words - 1);

   MemoryBank<Word, kLastDepth, Count> bank;

   template <class Source, int First>
   HLS_INLINE WordBanks(Source& source, MemoryId<First> first) : bank(source, first) {}

   template <int Banks>
   HLS_INLINE void read(const uint16_t (&address)[Banks], Word (&out)[Banks][Count]) const {
      bank.read(address[Banks - 1], out[Banks - 1]);
   }
   template <int Banks>
   HLS_INLINE void write(const uint16_t (&address)[Banks], const Word (&in)[Banks][Count]) {
      bank.write(address[Banks - 1], in[Banks - 1]);
   }
};

/// `Count` deep memories that are read together at one address and written together at another: a row of the map with
/// F words a column. Several banks have a register each behind them, so that the choice of the bank has a clock for
/// itself. Reads: 3 clocks, of one bank 2; writes: 1. Memory: the words, the last of several banks rounded up to a
/// power of two. BankBits: 12, as a block RAM holds 4096 words in its narrowest useful shape, or more.
template <class Word, int Words, int Count, int BankBits = 12>
struct PhaseMemory {
   static constexpr int kBankBits = BankBits;
   static constexpr int kBankWords = 1 << kBankBits;
   using Banks = WordBanks<Word, Words, Count, kBankWords>;
   static constexpr int kBanks = Banks::kBanks;
   static constexpr int kMemories = Banks::kMemories;
   static constexpr int kReadClocks = kBanks == 1 ? 2 : 3;

   Banks banks;
   uint16_t read_address[kBanks];
   uint8_t bank;
   // clock 1
   Word read_words[kBanks][Count];
   uint8_t read_bank;
   // clock 2 of several banks: block RAM is slow to show its data
   Word held_words[kBanks][Count];
   uint8_t held_bank;
   // the last clock
   Word ready_words[Count];
   // what is written
   Word write_words[kBanks][Count];
   uint16_t write_address[kBanks];

   template <class Source, int First>
   HLS_INLINE PhaseMemory(Source& memories, MemoryId<First> first) : banks(memories, first) {
      start(*this);
   }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("read_address", read_address);
      if constexpr (kBanks > 1) visit("bank", bank);
      visit("read_words", read_words);
      if constexpr (kBanks > 1) visit("read_bank", read_bank);
      if constexpr (kBanks > 1) visit("held_words", held_words);
      if constexpr (kBanks > 1) visit("held_bank", held_bank);
      visit("ready_words", ready_words);
      visit("write_words", write_words);
      visit("write_address", write_address);
   }

   /// from: the address that is read in the next clock; writes: `in` is to be written at `to`.
   HLS_INLINE void clock(uint16_t from, bool writes, uint16_t to, const Word (&in)[Count]) {
      Word stored[kBanks][Count];
      banks.read(read_address, stored);
      banks.write(write_address, write_words);
      HLS_UNROLL
      for (int w = 0; w < Count; ++w) {
         Word chosen = kBanks == 1 ? read_words[0][w] : held_words[0][w];
         HLS_UNROLL
         for (int b = 1; b < kBanks; ++b) chosen = select<Word>(held_bank == b, held_words[b][w], chosen);
         ready_words[w] = chosen;
         HLS_UNROLL
         for (int b = 0; b < kBanks; ++b) {
            held_words[b][w] = read_words[b][w];
            read_words[b][w] = stored[b][w];
         }
      }
      held_bank = read_bank;
      read_bank = bank;
      bank = uint8_t(from >> kBankBits);
      HLS_UNROLL
      for (int b = 0; b < kBanks; ++b) {
         const bool hit = kBanks == 1 ? writes : writes & ((to >> kBankBits) == b);
         read_address[b] = inside(from, b);
         write_address[b] = inside(select<uint16_t>(hit, to, write_address[b]), b);
         HLS_UNROLL
         for (int w = 0; w < Count; ++w) write_words[b][w] = select<Word>(hit, in[w], write_words[b][w]);
      }
   }

  private:
   /// The place of an address in a bank.
   static HLS_INLINE uint16_t inside(uint16_t address, int bank) {
      if (kBanks == 1) return address;
      return uint16_t(address & (bank < kBanks - 1 ? kBankWords - 1 : Banks::kLastDepth - 1));
   }
};

}  // namespace stereo::semi_global
