// SPDX-License-Identifier: Apache-2.0
// The calibrations that benchmarks have beside their images.
#pragma once

#include <optional>
#include <string_view>

#include "program/depth/calibration.hpp"

namespace stereo::app {

/// Told by the content; nothing where it is neither:
/// - calib.txt of Middlebury and ETH3D, lengths in millimetres: cam0, cam1, baseline, doffs, width, height of a
/// rectified
///   pair, as m1, m2, t,
/// - KITTI's calib.txt and calib_cam_to_cam.txt, lengths in metres: of the cameras 2 and 3, else 0 and 1, as p1, p2,
/// and
///   from K, D, R, T of the latter as the other matrices.
/// Any bytes are safe. Throws InputError with one sentence, without a file name.
std::optional<Calibration> parse_benchmark_calibration(std::string_view text);

}  // namespace stereo::app
