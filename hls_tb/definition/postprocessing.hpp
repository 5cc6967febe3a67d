// SPDX-License-Identifier: Apache-2.0
// Post-processing by its definition (docs/algorithm.md, "From a map with holes to a depth map"), for tests: one
// function for each stage, plain loops, the right image as reference.
#pragma once

#include "definition/stages.hpp"
#include "support/matching_groups.hpp"

namespace stereo {

/// g of each pixel, divided by 2^shift and 63 at most.
GrayImage margins(const CostVolume& sums, const DisparityMap& winners, int shift);

/// F1. n of each pixel, 0 where it is not valid.
GrayImage neighbours(const DisparityMap& map);

/// F1 and F2. Validity, and the confidence where the options have it.
DisparityMap supported(const DisparityMap& map, const GrayImage& margins, const PostProcessing& options);

/// F3.
DisparityMap holes_filled(const DisparityMap& map);

/// The stages that are on. margins: only needed for a confidence.
DisparityMap post_processed(const DisparityMap& map, const GrayImage& margins, const PostProcessing& options);

}  // namespace stereo
