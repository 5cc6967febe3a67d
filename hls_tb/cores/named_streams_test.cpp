// SPDX-License-Identifier: Apache-2.0
// The small named cores of every family as streams: frames in a row, cut ones, bubbles, resets, silence and clocks.
#include <gtest/gtest.h>

#include <set>
#include <string>
#include <vector>

#include "engines/clocked/core_modules.hpp"
#include "engines/configurations.hpp"
#include "engines/families.hpp"
#include "random_cores/core_check.hpp"
#include "testing/seed.hpp"
#include "testing/tested_cores.hpp"

namespace stereo::test {
namespace {

/// Small ones. Block matching has core_stream_test.cpp for its options, but for several clocks a pixel pair.
std::vector<std::string> chosen() {
   std::vector<std::string> names;
   for (const std::size_t place : tested_configurations()) {
      const Configuration& entry = configurations()[place];
      const bool is_small = entry.shape.image.width_px <= 100;
      const bool is_folded = entry.shape.schedule.clocks_per_group > 1;
      if (is_small && (entry.use == "tiny" || entry.family != "block_matching" || is_folded))
         names.push_back(entry.name);
   }
   return names;
}

class NamedStreamTest : public ::testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Named, NamedStreamTest, ::testing::ValuesIn(chosen()),
                         [](const auto& test) { return test.param; });

TEST_P(NamedStreamTest, GivesTheMapsOfTheDefinitionAtTheirClocks) {
   for (uint64_t round = 0; round < 3; ++round) {
      const CoreCheck check = check_core(core_module(GetParam()), test_seed() + round);
      EXPECT_EQ(check.problem, "");
      EXPECT_GT(check.maps, 0);
   }
}

TEST(NamedStreams, AreOfEveryFamily) {
   std::set<std::string> of_cores, all;
   for (const std::string& name : chosen()) of_cores.insert(find_configuration(name)->family);
   for (const Family& family : families()) all.insert(family.name);
   EXPECT_EQ(of_cores, all);
}

}  // namespace
}  // namespace stereo::test
