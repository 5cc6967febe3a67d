// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "program/depth/calibration_tree.hpp"

namespace stereo::app {

/// JSON of MATLAB's stereoParameters, jsonencode(stereoParams) or jsonencode(toStruct(stereoParams)), of releases with
/// matrices for row vectors, RotationOfCamera2 and IntrinsicMatrix, or for columns, PoseCamera2 and K: camera 1 is the
/// left one. MATLAB's first pixel is 1, OpenCV's 0. Nothing where the tree is another one. Throws InputError with one
/// sentence, without a file name.
std::optional<Calibration> parse_matlab(const Tree& tree);

}  // namespace stereo::app
