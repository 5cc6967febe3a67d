// SPDX-License-Identifier: Apache-2.0
#include "definition/dynamic_range/stress_pairs.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "definition/dynamic_range/matching_input.hpp"
#include "definition/dynamic_range/reference_model.hpp"
#include "testing/seed.hpp"

namespace stereo::test {
namespace {

using namespace dynamic_range;

// The options of tiny_dynamic, and those that change what its map shows.
std::vector<Matching> kinds() {
   const Matching plain{DisparityCount{32}, dynamic_range::WindowRange{16}, MatchingWindow{5}};
   Matching census = plain, deep = plain, dense = plain;
   census.codes = Codes::census;
   deep.pixel_bits = 12;
   dense.subpixel = dense.median = dense.confidence = dense.fill_holes = true;
   dense.support_threshold = 6;
   return {plain, census, deep, dense};
}

TEST(OwnStressPairs, ShowEachNeighbourThatMayDifferByTwo) {
   for (const Matching& matching : kinds()) {
      Random random(test_seed());
      const std::vector<DeepPair> pairs = own_stress_pairs(matching, 64, 32, random);
      EXPECT_LE(pairs.size(), 8u);
      for (const auto side : {&NeighbourAgreement::left, &NeighbourAgreement::right, &NeighbourAgreement::above,
                              &NeighbourAgreement::below})
         for (const Agreement may : {Agreement{-2, 1}, Agreement{-1, 2}}) {
            NeighbourAgreement wrong;
            wrong.*side = may;
            const bool is_shown = std::ranges::any_of(pairs, [&](const DeepPair& pair) {
               const auto ranges = block_ranges(coarse_map(pair.left, pair.right, matching), wrong);
               return match_with_targets(pair.left, pair.right, search_targets(ranges, matching), matching) !=
                      match_reference(pair.left, pair.right, matching);
            });
            EXPECT_TRUE(is_shown) << describe(matching) << ": " << may.lowest << " ... " << may.highest;
         }
   }
}

TEST(OwnStressPairs, ASeedIsASetOfPairs) {
   Random one(3), same(3), other(4);
   const Matching matching = kinds().front();
   const std::vector<DeepPair> pairs = own_stress_pairs(matching, 64, 32, one);
   ASSERT_FALSE(pairs.empty());
   const auto pixels = [](const std::vector<DeepPair>& some) { return some.front().left.pixels; };
   EXPECT_EQ(pixels(pairs), pixels(own_stress_pairs(matching, 64, 32, same)));
   EXPECT_NE(pixels(pairs), pixels(own_stress_pairs(matching, 64, 32, other)));
}

TEST(OwnStressPairs, OfLargeImagesThereAreNone) {
   Random random(test_seed());
   EXPECT_TRUE(own_stress_pairs(kinds().front(), 640, 480, random).empty());
}

}  // namespace
}  // namespace stereo::test
