// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "raster_counter.hpp"
#include "stereo_config.hpp"
#include "stream.hpp"

namespace stereo {

/// What is compared: a grey value, a filtered pixel or a census transform.
template <const StereoConfig& C>
using Feature = uint_of_bits<C.feature_bits()>;

/// One group of both images, sorted by their roles: the reference, whose pixels get disparities, and the image that is
/// searched.
template <const StereoConfig& C>
struct FeatureGroup {
   Feature<C> search[C.pixels_per_clock];
   Feature<C> reference[C.pixels_per_clock];
   bool start_of_frame = false;
   bool valid = false;

   HLS_INLINE FeatureGroup() {
      fill<Feature<C>>(search, 0);
      fill<Feature<C>>(reference, 0);
   }
};

/// Gives each group its place in the frame. 1 clock.
template <const StereoConfig& C>
struct Raster {
   FeatureGroup<C> features;
   RasterCounter<C.width_px, C.row_groups(), C.delay_groups(), C.aggregation == Aggregation::direct> place;

   HLS_INLINE void clock(const FeatureGroup<C>& in) {
      place.clock(in.valid, in.start_of_frame);
      HLS_UNROLL
      for (int p = 0; p < C.pixels_per_clock; ++p) {
         features.search[p] = in.search[p];
         features.reference[p] = in.reference[p];
      }
      features.valid = in.valid;
   }
};

}  // namespace stereo
