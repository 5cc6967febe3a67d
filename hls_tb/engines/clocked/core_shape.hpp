// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "support/image.hpp"
#include "support/pixel_bits.hpp"
#include "support/schedule.hpp"
#include "support/settings.hpp"

namespace stereo {

/// What everybody around a core must know of it, whatever it computes.
struct CoreShape {
   Image image;
   int output_width_px;  ///< of the map; it is as high as the images
   int disparity_bits;   ///< of one pixel in the output word: 8, 16 or 24 (LaneLayout)
   int steps_per_pixel;  ///< of a disparity: 1, or 16 for sixteenths of a pixel
   Schedule schedule;
   SettingList settings;     ///< that its ports take; none where they are constants
   int pixel_bits = 8;       ///< of a grey value
   bool turns_rows = false;  ///< rows go back and forth in memories: addresses rise in one row and fall in the next
   // The search range, in pixels; of a stage that has none, a usual one.
   int first_disparity = 0;
   int disparities = 16;
   // What the outputs have beside the disparities.
   bool has_confidence = false;
   bool has_filled = false;
};

template <class Core>
inline constexpr bool kTurnsRows = [] {
   if constexpr (requires { Core::kTurnsRows; }) return Core::kTurnsRows;
   else return false;
}();

template <class Core>
inline constexpr int kFirstDisparity = [] {
   if constexpr (requires { Core::kConfig.min_disparity; }) return Core::kConfig.min_disparity;
   else return 0;
}();
template <class Core>
inline constexpr int kDisparities = [] {
   if constexpr (requires { Core::kConfig.disparities; }) return Core::kConfig.disparities;
   else return 16;
}();

template <class Core>
inline constexpr bool kShowsConfidence = [] {
   if constexpr (requires { Core::kConfig.has_confidence(); }) return Core::kConfig.has_confidence();
   else return false;
}();
template <class Core>
inline constexpr bool kShowsFilled = [] {
   if constexpr (requires { Core::kConfig.fill_holes; }) return Core::kConfig.fill_holes;
   else return false;
}();

template <class Core>
constexpr CoreShape core_shape() {
   SettingList settings;
   if constexpr (kHasSettingPorts<Core::kConfig>) settings = setting_list(Core::kConfig);
   return {Core::kConfig,
           Core::kConfig.output_width_px(),
           Core::kConfig.disparity_bits(),
           Core::kConfig.steps_per_pixel(),
           Core::kSchedule,
           settings,
           kPixelBits<Core::kConfig>,
           kTurnsRows<Core>,
           kFirstDisparity<Core>,
           kDisparities<Core>,
           kShowsConfidence<Core>,
           kShowsFilled<Core>};
}

}  // namespace stereo
