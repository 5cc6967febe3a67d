// SPDX-License-Identifier: Apache-2.0
#include "phase_correlation/phase_distance.hpp"

#include <gtest/gtest.h>

#include "definition/phase_correlation/reference_model.hpp"
#include "scene/random.hpp"
#include "testing/seed.hpp"

namespace stereo::test {
namespace {

template <int Scales>
constexpr phase_correlation::Config kWithScales{
    {.width_px = 40, .height_px = 20}, {DisparityCount{8}, phase_correlation::PhaseScales{Scales}}, {}};

template <int Scales>
void expect_distances() {
   static constexpr const auto& C = phase_correlation::kCodeConfig<kWithScales<Scales>>;
   using Distance = FeatureDistance<phase_correlation::kCodeConfig<kWithScales<Scales>>, phase_correlation::kPhaseCost>;
   const int codes = 1 << C.feature_bits();
   Random random(test_seed());
   int most = 0;
   for (int i = 0; i < codes; ++i) {
      const uint32_t a = uint32_t(random.below(codes)), b = a ^ uint32_t(i);  // every difference
      const int got = Distance::second(Distance::first(Feature<C>(a), Feature<C>(b)));
      ASSERT_EQ(got, phase_correlation::code_cost(a, b, Scales)) << a << ' ' << b;
      most = got > most ? got : most;
   }
   EXPECT_EQ(most, C.largest_pixel_cost());
}

TEST(PhaseDistance, IsThatOfTheDefinition) {
   expect_distances<1>();
   expect_distances<2>();
   expect_distances<3>();
}

}  // namespace
}  // namespace stereo::test
