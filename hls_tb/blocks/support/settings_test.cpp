// SPDX-License-Identifier: Apache-2.0
#include "support/settings.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace stereo::test {
namespace {

template <int Least, int Largest>
void expect_limits() {
   for (int value = 0; value <= UINT16_MAX; ++value)
      ASSERT_EQ((limited<Least, Largest>(uint16_t(value))), std::clamp(value, Least, Largest)) << value;
}

/// Ports of a core without the shell may bring anything.
TEST(Settings, WhatIsBeyondALimitCountsAsTheLimit) {
   expect_limits<3, 5>();
   expect_limits<0, 22>();
   expect_limits<1, 255>();
   expect_limits<0, 4095>();
   expect_limits<7, 7>();
   expect_limits<0, 0>();
}

}  // namespace
}  // namespace stereo::test
