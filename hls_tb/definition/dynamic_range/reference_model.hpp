// SPDX-License-Identifier: Apache-2.0
// Matching with a dynamic range by its definition, docs/algorithm.md, for tests: plain loops.
#pragma once

#include <stdexcept>

#include "definition/dynamic_range/search_windows.hpp"
#include "definition/stages.hpp"
#include "dynamic_range/matching.hpp"

namespace stereo::dynamic_range {

/// The code of each pixel.
CensusImage codes_of(const GrayImage& image, const Matching& matching);
CensusImage codes_of(const DeepImage& image, const Matching& matching);

/// The cost of two codes.
int code_cost(uint64_t a, uint64_t b, const Matching& matching);

/// Y5 to the end, with these targets. Throws as match_reference does.
DisparityMap match_with_targets(const DeepImage& left, const DeepImage& right, const Targets& targets,
                                const Matching& matching);

/// All of it. Throws std::invalid_argument as check_matching_input does.
DisparityMap match_reference(const GrayImage& left, const GrayImage& right, const Matching& matching);
DisparityMap match_reference(const DeepImage& left, const DeepImage& right, const Matching& matching);

}  // namespace stereo::dynamic_range
