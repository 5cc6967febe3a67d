// SPDX-License-Identifier: Apache-2.0
#include "program/postprocessing/postprocessing.hpp"

#include "program/postprocessing/confidence.hpp"
#include "program/postprocessing/speckles.hpp"

namespace stereo::app {

nlohmann::json postprocessing_json(const Postprocessing& options) {
   return {{"speckle_window_px", options.speckle_window_px},
           {"speckle_range_px", options.speckle_range_px},
           {"least_confidence", options.least_confidence}};
}

namespace {

template <class Match, class Pair>
ProcessedMap processed(const Match& match, const Pair& pair, const MapGeometry& geometry,
                       const Postprocessing& options) {
   ProcessedMap result{match(pair), std::nullopt};
   DisparityMap& map = result.map;
   if (options.needs_confidence()) {
      result.confidence = confidence(map, other_map(match, pair), geometry, pair.left.width);
      for (std::size_t i = 0; i < map.valid.size(); ++i)
         if (result.confidence->pixels[i] < options.least_confidence) map.valid[i] = 0;
   }
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
