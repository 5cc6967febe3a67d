// SPDX-License-Identifier: Apache-2.0
// Lists of types for typed tests.
#pragma once

#include <gtest/gtest.h>

namespace stereo::test {

/// Two lists of types as one.
template <class First, class Second>
struct Both;
template <class... First, class... Second>
struct Both<::testing::Types<First...>, ::testing::Types<Second...>> {
   using Configs = ::testing::Types<First..., Second...>;
};

/// Each type takes the compiler as long as a small test: the fast set has `Few`, which stand for all; the program of
/// the slow set, for which CMake defines STEREO_ALL_TYPES, has all.
#ifdef STEREO_ALL_TYPES
template <class Few, class More>
using FewOrAll = typename Both<Few, More>::Configs;
#else
template <class Few, class More>
using FewOrAll = Few;
#endif

}  // namespace stereo::test
