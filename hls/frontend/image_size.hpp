// SPDX-License-Identifier: Apache-2.0
// What the blocks of a core compare the place in a frame with: constants, or registers where the size comes from ports.
#pragma once

#include <type_traits>

#include "support/raster_counter.hpp"

namespace stereo {

/// Whether ports say how large the images are, up to the size of the configuration.
template <const auto& C>
inline constexpr bool kRunTimeSize = [] {
   if constexpr (requires { C.run_time_size; }) return C.run_time_size;
   else return false;
}();

/// All frames have the size of the configuration.
template <const auto& C>
struct FixedSize {
   static constexpr bool kFixed = true;
   static constexpr FixedRaster<C.width_px, C.row_groups(), C.delay_groups()> windows = {};
   static constexpr FixedRaster<C.output_width_px(), C.row_groups(), 1> map = {};
   static constexpr FixedRaster<C.width_px, C.row_groups(), C.transform_groups()> transform = {};
   static constexpr int last_map_column = C.first_map_column() + C.output_width_px() - 1;
};

/// The size that the ports show. It may change only while the core is reset: from the clock after the reset on the
/// registers have what the port shows, which is what the core must see until the next reset.
template <const auto& C>
struct RunTimeSize {
   static constexpr bool kFixed = false;
   static constexpr int kColumnsLeftOut = C.width_px - C.output_width_px();

   RunTimeRaster<C.width_px, C.row_groups(), C.delay_groups()> windows;
   RunTimeRaster<C.output_width_px(), C.row_groups(), 1> map;
   RunTimeRaster<C.width_px, C.row_groups(), C.transform_groups()> transform;
   uint16_t last_map_column;

   HLS_INLINE RunTimeSize() { start(*this); }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("windows", windows);
      if constexpr (C.median) visit("map", map);
      if constexpr (C.has_transform()) visit("transform", transform);
      visit("last_map_column", last_map_column, C.first_map_column() + C.output_width_px() - 1);
   }

   HLS_INLINE void clock(uint16_t width, uint16_t height) {
      const uint16_t row_groups = uint16_t(height / unsigned(C.pixels_per_clock));
      windows.clock(width, row_groups);
      if constexpr (C.median) map.clock(uint16_t(width - unsigned(kColumnsLeftOut)), row_groups);
      if constexpr (C.has_transform()) transform.clock(width, row_groups);
      constexpr int kBehind = kColumnsLeftOut - C.first_map_column() + 1;
      last_map_column = at_most<C.width_px - 1>(unsigned(int(width) - kBehind));
   }
};

/// Whether a group that is counted is not behind another one, which is the group `last` where the images have the
/// configuration's size, and as far from their lower border where they do not.
template <const auto& C, class Raster>
HLS_INLINE bool is_until(uint16_t group, int last, const Raster& raster) {
   return int16_t(group - raster.groups) <= last - C.row_groups();
}

}  // namespace stereo
