// SPDX-License-Identifier: Apache-2.0
#include "support/dense_packed.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "scene/random.hpp"
#include "testing/seed.hpp"

namespace stereo::test {
namespace {

template <int LaneBits, int Lanes, int WordBits>
struct Shape {
   using Pack = DensePacked<LaneBits, Lanes, WordBits>;
   static constexpr int kBits = LaneBits, kLanes = Lanes, kWordBits = WordBits;
};

template <class Shape>
class DensePackedTest : public ::testing::Test {};
using Shapes = ::testing::Types<Shape<1, 1, 8>, Shape<5, 8, 16>, Shape<7, 8, 16>, Shape<4, 8, 16>, Shape<8, 3, 8>,
                                Shape<11, 7, 16>, Shape<16, 2, 16>, Shape<3, 2, 16>>;
TYPED_TEST_SUITE(DensePackedTest, Shapes);

/// By definition: bit b of lane i is bit i * bits + b of the words side by side.
TYPED_TEST(DensePackedTest, LanesStandSideBySideWithoutABitBetweenThem) {
   using Pack = typename TypeParam::Pack;
   constexpr int kBits = TypeParam::kBits, kLanes = TypeParam::kLanes, kWordBits = TypeParam::kWordBits;
   ASSERT_EQ(Pack::kWords, (kBits * kLanes + kWordBits - 1) / kWordBits);
   Random random(test_seed());
   for (int round = 0; round < 200; ++round) {
      typename Pack::Lane lanes[kLanes];
      typename Pack::Word packed[Pack::kWords];
      std::vector<uint64_t> expected(std::size_t(Pack::kWords), 0);
      const uint64_t mask = (uint64_t(1) << kBits) - 1;
      for (int i = 0; i < kLanes; ++i) {
         const uint64_t value = round == 0 ? mask : mix_bits(random.bits()) & mask;
         lanes[i] = typename Pack::Lane(value);
         for (int bit = 0; bit < kBits; ++bit) {
            const int at = i * kBits + bit;
            expected[std::size_t(at / kWordBits)] |= (value >> bit & 1) << (at % kWordBits);
         }
      }
      Pack::pack(lanes, packed);
      for (int w = 0; w < Pack::kWords; ++w) ASSERT_EQ(packed[w], expected[std::size_t(w)]) << "word " << w;
      for (int i = 0; i < kLanes; ++i) ASSERT_EQ(Pack::lane(packed, i), lanes[i]) << "lane " << i;
   }
}

}  // namespace
}  // namespace stereo::test
