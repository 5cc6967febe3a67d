// SPDX-License-Identifier: Apache-2.0
#include "app/options_json.hpp"

namespace stereo::app {
namespace {

const char* cost_word(Cost cost) { return cost == Cost::sad ? "sad" : cost == Cost::ssd ? "ssd" : "census"; }

}  // namespace

nlohmann::json options_json(const MatchingParameters& options) {
   return {{"disparities", options.disparities},
           {"window_px", options.window_px},
           {"min_disparity", options.min_disparity},
           {"reference", options.reference == Reference::left ? "left" : "right"},
           {"cost", cost_word(options.cost)},
           {"census_width_px", options.census_width_px},
           {"census_height_px", options.census_height_px},
           {"prefilter", options.prefilter == Prefilter::xsobel ? "xsobel" : "none"},
           {"prefilter_cap", options.prefilter_cap},
           {"ties", options.ties == Ties::largest ? "largest" : "smallest"},
           {"left_right_threshold", options.left_right_threshold},
           {"uniqueness_percent", options.uniqueness_percent},
           {"texture_threshold", options.texture_threshold},
           {"subpixel", options.subpixel},
           {"median", options.median}};
}

}  // namespace stereo::app
