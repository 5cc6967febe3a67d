// SPDX-License-Identifier: Apache-2.0
#include "testing/map_compare.hpp"

namespace stereo::test {
namespace {

struct Size {
   int width, height, depth;
   bool operator==(const Size&) const = default;
};

std::ostream& operator<<(std::ostream& out, Size size) {
   return out << size.width << 'x' << size.height << 'x' << size.depth;
}

/// Compares value(x, y, d) of both; values holds them in that order, d fastest.
template <class Value>
::testing::AssertionResult compare(Size expected_size, const std::vector<Value>& expected, Size got_size,
                                   const std::vector<Value>& got) {
   if (!(expected_size == got_size))
      return ::testing::AssertionFailure() << "expected size " << expected_size << ", got " << got_size;
   if (expected.empty()) return ::testing::AssertionFailure() << "nothing to compare: size " << expected_size;
   if (expected.size() != got.size())
      return ::testing::AssertionFailure() << "expected " << expected.size() << " values, got " << got.size();
   std::size_t first = 0, differences = 0;
   for (std::size_t i = expected.size(); i-- > 0;)
      if (expected[i] != got[i]) {
         first = i;
         ++differences;
      }
   if (differences == 0) return ::testing::AssertionSuccess();
   const std::size_t depth = std::size_t(expected_size.depth), width = std::size_t(expected_size.width);
   auto failure = ::testing::AssertionFailure();
   failure << "x=" << first / depth % width << " y=" << first / depth / width;
   if (depth > 1) failure << " d=" << first % depth;
   return failure << " expected=" << int(expected[first]) << " got=" << int(got[first]) << " (" << differences << " of "
                  << expected.size() << " differ)";
}

}  // namespace

::testing::AssertionResult same_map(const GrayImage& expected, const GrayImage& got) {
   return compare({expected.width, expected.height, 1}, expected.pixels, {got.width, got.height, 1}, got.pixels);
}

::testing::AssertionResult same_map(const DisparityMap& expected, const DisparityMap& got) {
   if (expected.subpixel != got.subpixel)
      return ::testing::AssertionFailure() << "one map is in pixels, the other in sixteenths of a pixel";
   const Size expected_size{expected.width, expected.height, 1}, got_size{got.width, got.height, 1};
   const auto disparities = compare(expected_size, expected.disparity, got_size, got.disparity);
   if (!disparities) return disparities;
   const auto validity = compare(expected_size, expected.valid, got_size, got.valid);
   if (!validity) return ::testing::AssertionFailure() << "validity: " << validity.message();
   if (expected.confidence.empty() && got.confidence.empty() && expected.filled.empty() && got.filled.empty())
      return validity;
   if (expected.confidence.empty() != got.confidence.empty() || expected.filled.empty() != got.filled.empty())
      return ::testing::AssertionFailure() << "one map has a confidence or filled holes, the other has not";
   if (!expected.confidence.empty())
      if (const auto same = compare(expected_size, expected.confidence, got_size, got.confidence); !same)
         return ::testing::AssertionFailure() << "confidence: " << same.message();
   if (!expected.filled.empty())
      if (const auto same = compare(expected_size, expected.filled, got_size, got.filled); !same)
         return ::testing::AssertionFailure() << "filled: " << same.message();
   return validity;
}

::testing::AssertionResult same_volume(const CostVolume& expected, const CostVolume& got) {
   return compare({expected.width, expected.height, expected.disparities}, expected.values,
                  {got.width, got.height, got.disparities}, got.values);
}

}  // namespace stereo::test
