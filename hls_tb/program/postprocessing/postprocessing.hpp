// SPDX-License-Identifier: Apache-2.0
// What the program does with a map after the matching, on request. There is no hardware for it, but for a confidence
// that the matcher itself gives.
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <optional>

#include "definition/disparity_map.hpp"
#include "definition/gray_image.hpp"
#include "definition/map_geometry.hpp"

namespace stereo::app {

struct Postprocessing {
   int speckle_window_px = 0;  ///< largest speckle that is removed; 0: off
   int speckle_range_px = 1;
   int least_confidence = 0;            ///< pixels with less become invalid; 0: off
   int surest_percent = 100;            ///< of the map's pixels, only these stay
   const GrayImage* counted = nullptr;  ///< as large as the map: 0 where a pixel is none of those; null: all are
   bool measured_only = false;          ///< filled pixels show nothing
   bool wants_confidence = false;       ///< even if nothing else needs it

   bool selects() const { return least_confidence > 0 || surest_percent < 100; }
   /// Pixels can become invalid.
   bool rejects() const { return speckle_window_px > 0 || selects() || measured_only; }
   bool needs_confidence() const { return wants_confidence || selects(); }
};

nlohmann::json postprocessing_json(const Postprocessing& options);

struct ProcessedMap {
   DisparityMap map;
   std::optional<GrayImage> confidence;  ///< of each pixel of the map, where it was needed or the matcher gives it
};

/// Matches and does what was asked for: first the confidence, then the speckles. A confidence that the matcher does not
/// give takes a second matching.
ProcessedMap match_and_process(const std::function<DisparityMap(const ImagePair&)>& match, const ImagePair& pair,
                               const MapGeometry& geometry, const Postprocessing& options);
ProcessedMap match_and_process(const std::function<DisparityMap(const DeepPair&)>& match, const DeepPair& pair,
                               const MapGeometry& geometry, const Postprocessing& options);

}  // namespace stereo::app
