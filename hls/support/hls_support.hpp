// SPDX-License-Identifier: Apache-2.0
// What the synthesis tool needs to hear, said once.
#pragma once

#include <cstdint>
#include <type_traits>

/// Stands before a loop over disparities, rows or columns that becomes parallel hardware. All arrays but the line
/// memories dissolve into registers, and only do so when every index is constant after unrolling.
#if defined(__clang__)
#define HLS_UNROLL _Pragma("clang loop unroll(full)")
#else
#define HLS_UNROLL
#endif

/// Marks every function of the core: one that stays a function, as large ones with several callers do, becomes a module
/// of its own, and the core then needs thousands of states.
#define HLS_INLINE inline __attribute__((always_inline))

namespace stereo {

/// A multiplexer. `condition ? a[i] : a[j]` on array elements is an lvalue choice, which clang turns into a choice of
/// addresses: the array would stay in memory and each access would cost a state.
template <class T>
HLS_INLINE constexpr T select(bool condition, T yes, T no) {
   return condition ? yes : no;
}

/// Sets every element in an unrolled loop; `= {}` would become a memset, which costs a state for each byte.
template <class T, int N>
HLS_INLINE void fill(T (&array)[N], T value) {
   HLS_UNROLL
   for (int i = 0; i < N; ++i) array[i] = value;
}

/// The smallest unsigned type of at least so many bits.
template <int Bits>
using uint_of_bits = std::conditional_t<
    (Bits <= 8), uint8_t,
    std::conditional_t<(Bits <= 16), uint16_t, std::conditional_t<(Bits <= 32), uint32_t, uint64_t>>>;

/// Bits that hold 0 ... largest.
constexpr int bits_for(int64_t largest) {
   int bits = 1;
   while (largest >> bits != 0) ++bits;
   return bits;
}

/// Tells the tool that `value` is never above `Largest`, which it cannot see in a counter that wraps by comparison: the
/// register then has just the bits that it needs. Costs nothing.
template <int Largest>
HLS_INLINE constexpr uint16_t at_most(unsigned value) {
   static_assert(Largest >= 0 && Largest <= UINT16_MAX, "counters have up to 16 bits");
   unsigned mask = 1;
   while (mask < unsigned(Largest)) mask = 2 * mask + 1;
   return uint16_t(value & mask);
}

/// An address in a ring of `Places` words, a power of two: it goes on at 0 behind the last one.
template <int Places>
HLS_INLINE constexpr uint16_t wrapped(unsigned address) {
   static_assert(Places > 0 && Places <= 1 << 15 && (Places & (Places - 1)) == 0, "the places must be a power of two");
   return uint16_t(address & (Places - 1));
}

}  // namespace stereo
