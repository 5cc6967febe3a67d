// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "definition/gray_image.hpp"

namespace stereo::fast {

/// The prefilter of docs/algorithm.md; values 0 ... 2*cap.
GrayImage prefilter_xsobel(const GrayImage& image, int cap, int threads);
DeepImage prefilter_xsobel(const DeepImage& image, int cap, int threads);

}  // namespace stereo::fast
