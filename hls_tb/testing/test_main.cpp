// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cstdlib>
#include <iostream>
#include <string>

#include "testing/seed.hpp"

uint64_t stereo::test::test_seed() {
   static const uint64_t seed = [] {
      const char* const text = std::getenv("STEREO_TEST_SEED");
      return text != nullptr ? std::stoull(text) : 20070914u;
   }();
   return seed;
}

int main(int argc, char** argv) {
   ::testing::InitGoogleTest(&argc, argv);
   setenv("STEREO_CORES", STEREO_CORE_FOLDER, 0);  // unless the caller knows better
   if (!GTEST_FLAG_GET(list_tests)) std::cout << "STEREO_TEST_SEED=" << stereo::test::test_seed() << std::endl;
   return RUN_ALL_TESTS();
}
