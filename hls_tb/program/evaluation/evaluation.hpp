// SPDX-License-Identifier: Apache-2.0
// What `stereo_hls evaluate` found, as JSON for programs and as tables for people.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "program/evaluation/masks.hpp"
#include "program/evaluation/measures.hpp"

namespace stereo::app {

struct NamedMeasures {
   std::string mask;  ///< as in NamedMask
   Measures measures;
};

struct EvaluatedMethod {
   std::string name;
   std::string kind;  ///< core, opencv or file
   Reference reference = Reference::left;
   nlohmann::json parameters;
   double milliseconds = 0;           ///< of the matching alone; NaN for a file
   std::vector<NamedMeasures> masks;  ///< without those that have no pixels
};

struct Evaluation {
   std::string left, right;  ///< paths of the images
   int width_px = 0, height_px = 0, border_px = 0;
   int threads = 1;  ///< of every matcher that was timed
   std::vector<EvaluatedMethod> methods;
};

/// Format "stereo-hls evaluation 1": fractions are 0 ... 1, what is not known (an error where nothing is valid, the
/// time of a file) is null, and masks that could not be made or have no pixels are absent.
nlohmann::json evaluation_json(const Evaluation& evaluation);

/// One table for each mask, a row for each method, percent and pixels.
std::string evaluation_text(const Evaluation& evaluation);

}  // namespace stereo::app
