// SPDX-License-Identifier: Apache-2.0
#include "support/fan_out.hpp"

#include <gtest/gtest.h>

#include "scene/random.hpp"
#include "testing/seed.hpp"

namespace stereo::test {
namespace {

template <class Value, int Count, int Span>
void expect_copies() {
   using Copies = FanOut<Value, Count, Span>;
   static_assert(Copies::kCopies * Span >= Count && (Copies::kCopies - 1) * Span < Count);
   Copies copies;
   for (int i = 1; i < Copies::kCopies; ++i) EXPECT_NE(copies.copy[i], copies.copy[i - 1]) << "would be joined";
   Random random(test_seed());
   copies.move(true, Value(7));
   Value shown = 7;
   for (int clock = 0; clock < 100; ++clock) {
      for (int reader = 0; reader < Count; ++reader) ASSERT_EQ(copies.get(reader), shown) << clock << ", " << reader;
      const Value value = Value(random.below(200));
      const bool moves = random.percent(60);
      copies.move(moves, value);
      if (moves) shown = value;
   }
}

TEST(FanOut, GivesEachReaderTheSameAndHoldsItBetweenMoves) {
   expect_copies<uint8_t, 12, 16>();
   expect_copies<uint8_t, 64, 16>();
   expect_copies<uint16_t, 19, 5>();
}

}  // namespace
}  // namespace stereo::test
