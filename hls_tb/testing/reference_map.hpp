// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "definition/block_matching/reference_model.hpp"

namespace stereo::test {

/// What the reference model finds with the options of a hardware configuration.
inline DisparityMap reference_map(const ImagePair& pair, const block_matching::Matching& matching) {
   return match_reference(pair.left, pair.right, matching);
}

}  // namespace stereo::test
