// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include "definition/block_matching/reference_model.hpp"

namespace stereo::test {

/// Succeeds when both have the same pixels, and at least one. The message shows x, y, expected and got of the first
/// difference and counts the others.
::testing::AssertionResult same_map(const GrayImage& expected, const GrayImage& got);
/// The same for disparities, validity and unit: valid pixels of one that are invalid in the other are shown as such.
::testing::AssertionResult same_map(const DisparityMap& expected, const DisparityMap& got);
/// The same for every disparity.
::testing::AssertionResult same_volume(const CostVolume& expected, const CostVolume& got);

}  // namespace stereo::test
