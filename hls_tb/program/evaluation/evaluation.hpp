// SPDX-License-Identifier: Apache-2.0
// What `stereo_hls evaluate` found, as JSON for programs and as tables for people.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "engines/algorithm.hpp"
#include "program/evaluation/masks.hpp"
#include "program/evaluation/measures.hpp"

namespace stereo::app {

struct NamedMeasures {
   std::string mask;  ///< as in NamedMask
   Measures measures;
};

/// The disparities that an algorithm looks for. Families without a smallest disparity look from 0 on.
DisparityRange range_of(const Algorithm& algorithm);

/// The measures of a map over the masks of its reference image, but those without pixels. range: the disparities that
/// the method looks for; without it there are no searchable columns.
std::vector<NamedMeasures> measure_masks(const DisparityImage& found, Reference reference,
                                         const std::optional<DisparityRange>& range, const DisparityImage& truth,
                                         const std::vector<NamedMask>& masks);

/// {mask: {measure: value}}, as in evaluation_json.
nlohmann::json measures_json(const std::vector<NamedMeasures>& masks);

struct EvaluatedMethod {
   std::string name;
   std::string kind;  ///< core, opencv or file
   Reference reference = Reference::left;
   nlohmann::json parameters = {};
   double milliseconds = 0;                ///< of the matching alone; NaN for a file
   std::vector<NamedMeasures> masks = {};  ///< without those that have no pixels
   std::vector<std::string> remarks = {};  ///< on truth that does not fit, as sentences
   std::string engine = {};                ///< of a core, as the next one
   nlohmann::json postprocessing = {};
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
