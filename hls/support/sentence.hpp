// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace stereo {

/// What is wrong, as one sentence that the compiler and the program can both show; empty when nothing is.
struct Sentence {
   static constexpr int kMost = 200;
   char text[kMost + 1] = {};
   int length = 0;

   constexpr Sentence() = default;
   constexpr Sentence(const char* words) { *this << words; }

   constexpr bool empty() const { return length == 0; }

   constexpr Sentence& operator<<(const char* words) {
      for (; *words != 0 && length < kMost; ++words) text[length++] = *words;
      return *this;
   }
   constexpr Sentence& operator<<(long long number) {
      if (number < 0) *this << "-";
      char digits[24] = {};
      int at = 23;
      do {
         const long long digit = number % 10;
         digits[--at] = char('0' + (digit < 0 ? -digit : digit));
         number /= 10;
      } while (number != 0);
      return *this << digits + at;
   }
   constexpr Sentence& operator<<(int number) { return *this << static_cast<long long>(number); }
};

/// The sentence in the name of this template is why a configuration cannot be built.
template <Sentence Problem>
struct CannotBuild {
   static_assert(Problem.empty(), "the sentence in CannotBuild<...> says why this configuration cannot be built");
   static constexpr bool kNothing = true;
};

/// Refuses to compile, with the sentence, unless C.problem() is empty.
template <const auto& C>
inline constexpr bool kCanBeBuilt = CannotBuild<C.problem()>::kNothing;

}  // namespace stereo
