// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "program/depth/calibration_tree.hpp"

namespace stereo::app {

/// camchain.yaml of Kalibr: cam0 is the left camera, cam1 the right one, lengths in metres. Nothing where the tree is
/// another one. Throws InputError with one sentence, without a file name.
std::optional<Calibration> parse_kalibr(const Tree& tree);

}  // namespace stereo::app
