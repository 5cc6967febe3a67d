// SPDX-License-Identifier: Apache-2.0
#include "support/packed.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "scene/random.hpp"
#include "testing/seed.hpp"

namespace stereo::test {
namespace {

template <int LaneBits, int Lanes>
struct Shape {
   using Pack = Packed<LaneBits, Lanes>;
   static constexpr int kBits = LaneBits, kLanes = Lanes;
};

template <class Shape>
class PackedTest : public ::testing::Test {};
using Shapes =
    ::testing::Types<Shape<1, 1>, Shape<1, 33>, Shape<5, 7>, Shape<8, 4>, Shape<8, 5>, Shape<10, 3>, Shape<11, 7>,
                     Shape<16, 2>, Shape<17, 3>, Shape<32, 2>, Shape<33, 3>, Shape<62, 2>, Shape<64, 2>>;
TYPED_TEST_SUITE(PackedTest, Shapes);

/// By definition: word w holds the next floor(32 / bits) lanes, at least one, the first in its lowest bits.
TYPED_TEST(PackedTest, LanesStandSideBySideInTheFewestWords) {
   using Pack = typename TypeParam::Pack;
   constexpr int kBits = TypeParam::kBits, kLanes = TypeParam::kLanes;
   int per_word = 1;
   while (per_word < kLanes && (per_word + 1) * kBits <= 32) ++per_word;
   int words = 0;
   while (words * per_word < kLanes) ++words;
   ASSERT_EQ(Pack::kWords, words);
   const uint64_t mask = kBits == 64 ? ~uint64_t(0) : (uint64_t(1) << kBits) - 1;
   Random random(test_seed());
   for (int round = 0; round < 200; ++round) {
      typename Pack::Lane lanes[kLanes];
      typename Pack::Word packed[Pack::kWords];
      std::vector<uint64_t> expected(std::size_t(words), 0);
      for (int i = 0; i < kLanes; ++i) {
         const uint64_t value = round == 0 ? mask : mix_bits(random.bits()) & mask;
         lanes[i] = typename Pack::Lane(value);
         expected[std::size_t(i / per_word)] |= value << (kBits * (i % per_word));
      }
      Pack::pack(lanes, packed);
      for (int w = 0; w < words; ++w) ASSERT_EQ(packed[w], expected[std::size_t(w)]) << "word " << w;
      for (int i = 0; i < kLanes; ++i) ASSERT_EQ(Pack::lane(packed, i), lanes[i]) << "lane " << i;
   }
}

}  // namespace
}  // namespace stereo::test
