// SPDX-License-Identifier: Apache-2.0
#include "definition/dynamic_range/stress_pairs.hpp"

#include <algorithm>
#include <array>

#include "definition/dynamic_range/reference_model.hpp"
#include "scene/stress_pairs.hpp"

namespace stereo::dynamic_range {
namespace {

constexpr int kLargest = 8192;  // pixels
constexpr int kTries = 4000;
constexpr std::array kSides{&NeighbourAgreement::left, &NeighbourAgreement::right, &NeighbourAgreement::above,
                            &NeighbourAgreement::below};

std::vector<NeighbourAgreement> off_by_one() {
   std::vector<NeighbourAgreement> all;
   for (const auto side : kSides)
      for (const Agreement may : {Agreement{-2, 1}, Agreement{-1, 2}}) {
         NeighbourAgreement wrong;
         wrong.*side = may;
         all.push_back(wrong);
      }
   return all;
}

}  // namespace

std::vector<DeepPair> own_stress_pairs(const Matching& matching, int width, int height, Random& random) {
   std::vector<DeepPair> found;
   if (width * height > kLargest) return found;
   std::vector<NeighbourAgreement> sought = off_by_one();
   for (int i = 0; i < kTries && !sought.empty(); ++i) {
      DeepPair pair =
          stress_pair(StressClass::patchwork, {width, height, 0, matching.disparities, matching.pixel_bits}, random);
      const DisparityMap coarse = coarse_map(pair.left, pair.right, matching);
      const Targets targets = search_targets(block_ranges(coarse), matching);
      const auto is_shown = [&](const NeighbourAgreement& wrong) {
         const Targets others = search_targets(block_ranges(coarse, wrong), matching);
         // Most often the windows stay where they are.
         if (others.low.values == targets.low.values && others.high.values == targets.high.values) return false;
         return match_with_targets(pair.left, pair.right, others, matching) !=
                match_with_targets(pair.left, pair.right, targets, matching);
      };
      if (std::erase_if(sought, is_shown) > 0) found.push_back(std::move(pair));
   }
   return found;
}

}  // namespace stereo::dynamic_range
