// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>

namespace stereo {

/// One step of SplitMix64: a hash of 64 bits that looks random.
constexpr uint64_t mix_bits(uint64_t value) {
   value += 0x9e3779b97f4a7c15;
   value = (value ^ (value >> 30)) * 0xbf58476d1ce4e5b9;
   value = (value ^ (value >> 27)) * 0x94d049bb133111eb;
   return value ^ (value >> 31);
}

/// Random numbers that are the same on every machine, which std:: distributions do not promise.
class Random {
  public:
   explicit Random(uint64_t seed) : state_(mix_bits(seed)) {}

   uint32_t bits() { return uint32_t(mix_bits(state_++) >> 32); }
   uint8_t byte() { return uint8_t(bits()); }
   /// 0 ... limit-1
   int below(int limit) { return int((uint64_t(bits()) * uint64_t(limit)) >> 32); }
   bool percent(int chance) { return below(100) < chance; }
   /// low ... high
   double between(double low, double high) { return low + (high - low) * double(bits()) / 4294967295.0; }

  private:
   uint64_t state_;
};

/// Another order of them.
void shuffle(auto& things, Random& random) {
   for (std::size_t i = things.size() - 1; i > 0; --i)
      std::swap(things[i], things[std::size_t(random.below(int(i) + 1))]);
}

}  // namespace stereo
