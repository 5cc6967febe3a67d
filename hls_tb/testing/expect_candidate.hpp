// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include "block_matching/config.hpp"
#include "testing/naive_winner.hpp"
#include "winner/candidate.hpp"

namespace stereo::test {

/// Compares what the configuration needs of a candidate of the whole range.
template <const auto& C>
void expect_candidate(const NaiveWinner& expected, const WindowCandidate<C>& got) {
   ASSERT_EQ(int(got.index), expected.index);
   ASSERT_EQ(int(got.cost), expected.cost);
   if constexpr (C.subpixel) {
      if (expected.below >= 0) {
         ASSERT_EQ(int(got.below), expected.below);
      }
      if (expected.above >= 0) {
         ASSERT_EQ(int(got.above), expected.above);
      }
   }
}

/// The same of the losers, which come a clock after the candidate.
template <const auto& C>
void expect_losers(const NaiveWinner& expected, const WindowLosers<C>& got) {
   if constexpr (C.has_uniqueness_check()) {
      ASSERT_EQ(int(got.cost), expected.cost);
      ASSERT_EQ(int(got.second), expected.second < 0 ? int(WindowLosers<C>::kNone) : expected.second);
   }
}

}  // namespace stereo::test
