// SPDX-License-Identifier: Apache-2.0
#include "program/postprocessing/postprocessing.hpp"

#include <algorithm>
#include <array>

#include "program/postprocessing/confidence.hpp"
#include "program/postprocessing/speckles.hpp"

namespace stereo::app {

nlohmann::json postprocessing_json(const Postprocessing& options) {
   nlohmann::json json{{"speckle_window_px", options.speckle_window_px},
                       {"speckle_range_px", options.speckle_range_px},
                       {"least_confidence", options.least_confidence}};
   if (options.surest_percent < 100) json["surest_percent"] = options.surest_percent;
   if (options.measured_only) json["measured_only"] = true;
   return json;
}

namespace {

GrayImage own_confidence(const DisparityMap& map) {
   GrayImage image(map.width, map.height);
   image.pixels = map.confidence;
   return image;
}

/// The largest confidence that so many percent of the counted pixels reach.
int reached_by(const GrayImage& confidence, int percent, const GrayImage* counted) {
   std::array<std::size_t, kLargestConfidence + 1> pixels{};
   std::size_t all = 0;
   for (std::size_t i = 0; i < confidence.pixels.size(); ++i) {
      if (counted && counted->pixels[i] == 0) continue;
      ++pixels[confidence.pixels[i]];
      ++all;
   }
   std::size_t reaching = 0;
   for (int least = kLargestConfidence; least > 0; --least) {
      reaching += pixels[std::size_t(least)];
      if (100 * reaching >= std::size_t(percent) * all) return least;
   }
   return 0;
}

void select(DisparityMap& map, const GrayImage& confidence, const Postprocessing& options) {
   const int least =
       std::max(options.least_confidence,
                options.surest_percent < 100 ? reached_by(confidence, options.surest_percent, options.counted) : 0);
   for (std::size_t i = 0; i < map.valid.size(); ++i) {
      if (confidence.pixels[i] >= least) continue;
      map.valid[i] = 0;
      if (!map.filled.empty()) map.filled[i] = 0;
   }
}

template <class Match, class Pair>
ProcessedMap processed(const Match& match, const Pair& pair, const MapGeometry& geometry,
                       const Postprocessing& options) {
   ProcessedMap result{match(pair), std::nullopt};
   DisparityMap& map = result.map;
   if (!map.confidence.empty()) result.confidence = own_confidence(map);
   else if (options.needs_confidence())
      result.confidence = confidence(map, other_map(match, pair), geometry, pair.left.width);
   if (options.selects()) select(map, *result.confidence, options);
   if (options.measured_only) std::fill(map.filled.begin(), map.filled.end(), uint8_t(0));
   if (options.speckle_window_px > 0) remove_speckles(map, options.speckle_window_px, options.speckle_range_px);
   return result;
}

}  // namespace

ProcessedMap match_and_process(const std::function<DisparityMap(const ImagePair&)>& match, const ImagePair& pair,
                               const MapGeometry& geometry, const Postprocessing& options) {
   return processed(match, pair, geometry, options);
}
ProcessedMap match_and_process(const std::function<DisparityMap(const DeepPair&)>& match, const DeepPair& pair,
                               const MapGeometry& geometry, const Postprocessing& options) {
   return processed(match, pair, geometry, options);
}

}  // namespace stereo::app
