// SPDX-License-Identifier: Apache-2.0
#include "winner/sort_three.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "scene/random.hpp"
#include "testing/seed.hpp"

namespace stereo::test {
namespace {

template <class Value>
void expect_sorted(std::array<int, 3> numbers) {
   SortThree<Value> block{};
   block.compare(Value(numbers[0]), Value(numbers[1]), Value(numbers[2]));
   std::ranges::sort(numbers);
   ASSERT_EQ(int(block.smallest()), numbers[0]);
   ASSERT_EQ(int(block.median()), numbers[1]);
   ASSERT_EQ(int(block.largest()), numbers[2]);
}

/// Three numbers 0 ... 2 stand for every order with every tie.
TEST(SortThree, EveryOrder) {
   for (int a = 0; a < 3; ++a)
      for (int b = 0; b < 3; ++b)
         for (int c = 0; c < 3; ++c)
            ASSERT_NO_FATAL_FAILURE(expect_sorted<uint8_t>({a, b, c})) << a << ' ' << b << ' ' << c;
}

TEST(SortThree, AnyNumbers) {
   Random random(test_seed());
   for (int i = 0; i < 2000; ++i) {
      const auto number = [&random] { return random.percent(20) ? 65535 : random.below(65536); };
      ASSERT_NO_FATAL_FAILURE(expect_sorted<uint16_t>({number(), number(), number()}));
   }
}

}  // namespace
}  // namespace stereo::test
