// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <iostream>
#include <stdexcept>

namespace stereo::app {

/// Throws std::runtime_error unless all that was printed has arrived.
inline void require_printed() {
   if (!std::cout.flush()) throw std::runtime_error("the result cannot be written to standard output");
}

}  // namespace stereo::app
