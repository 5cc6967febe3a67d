// SPDX-License-Identifier: Apache-2.0
// What a pair of images or its map shows of wrong input. Warnings are sentences that end with a line feed, or nothing.
#pragma once

#include <optional>
#include <string>

#include "definition/disparity_map.hpp"
#include "definition/map_geometry.hpp"
#include "program/depth/matched_features.hpp"

namespace stereo::app {

/// Rows by which the images of a rectified pair may differ before block matching suffers.
inline constexpr double kLargestVerticalOffset = 1.0;

struct VerticalOffset {
   double median_px = 0;  ///< median of the rows' differences between matched features, 0 or more
   int features = 0;
};

/// Nothing without features.
std::optional<VerticalOffset> vertical_offset(const std::vector<FeatureOffset>& features);

/// Whether the images do not look rectified; else whether left and right look exchanged; else whether disparities of
/// features lie outside of the range that is searched. `geometry`: of the maps to come.
std::string pair_warning(const ImagePair& pair, const MapGeometry& geometry);

/// Whether many pixels have the last disparity that is searched, as where the range is too short. For pairs whose
/// features say nothing.
std::string last_disparity_warning(const DisparityMap& map, const MapGeometry& geometry);

}  // namespace stereo::app
