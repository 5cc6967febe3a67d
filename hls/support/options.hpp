// SPDX-License-Identifier: Apache-2.0
// A group of options lists its members once:
//
//    template <class Self, class Visitor>
//    static constexpr void options(Self& self, Visitor& visit) {
//       visit("prefilter_cap", self.prefilter_cap, 1, 63, "the prefilter's cap"); // a number with its limits
//       visit("median", self.median);                                            // a flag, or a choice among words
//    }
//
// Their names in the program, in JSON and in the manifests, and the check of their limits follow from the list.
#pragma once

#include "support/sentence.hpp"

namespace stereo {

/// The name of a choice among enumerators, and their words in the order of their values 0, 1, 2 ... Specialised beside
/// each choice.
template <class Choice>
struct Words;

template <>
struct Words<bool> {
   static constexpr const char* kName = "bool";
   static constexpr const char* kWords[] = {"false", "true"};
};

/// No upper limit of a number.
inline constexpr int kUnlimited = 2147483647;

/// The visitor that looks for the first number beyond its limits.
struct LimitCheck {
   Sentence problem;

   constexpr void operator()(const char*, int value, int low, int high, const char* what) {
      if (!problem.empty() || (value >= low && value <= high)) return;
      problem << what << " is " << value << " but must be ";
      if (high == kUnlimited) problem << "at least " << low;
      else problem << low << " ... " << high;
   }
   template <class Choice>
   constexpr void operator()(const char*, const Choice&) {}
};

template <class Options>
constexpr Sentence first_beyond_limits(const Options& options) {
   LimitCheck check;
   Options::options(options, check);
   return check.problem;
}

}  // namespace stereo
