// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "support/matching_options.hpp"
#include "support/pixel_bits.hpp"
#include "support/registers.hpp"

namespace stereo {

/// What is compared: a grey value, a filtered pixel or a census transform.
template <const auto& C>
using Feature = uint_of_bits<C.feature_bits()>;

/// One group of both images, sorted by their roles: the reference, whose pixels get disparities, and the image that is
/// searched.
template <const auto& C>
struct FeatureGroup {
   Feature<C> search[C.pixels_per_clock];
   Feature<C> reference[C.pixels_per_clock];
   bool start_of_frame;
   bool valid;

   HLS_INLINE FeatureGroup() { start(*this); }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("search", search);
      visit("reference", reference);
      visit("start_of_frame", start_of_frame);
      visit("valid", valid);
   }
};

/// The group of a core that compares grey values.
template <const auto& C>
HLS_INLINE FeatureGroup<C> grey_values(const CoreInput<C>& in) {
   FeatureGroup<C> group;
   HLS_UNROLL
   for (int p = 0; p < C.pixels_per_clock; ++p) {
      group.search[p] = C.reference == Reference::right ? in.left[p] : in.right[p];
      group.reference[p] = C.reference == Reference::right ? in.right[p] : in.left[p];
   }
   group.start_of_frame = in.start_of_frame;
   group.valid = in.valid;
   return group;
}

}  // namespace stereo
