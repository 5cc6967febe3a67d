// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace stereo::test {

/// Env STEREO_TEST_SEED, else a fixed number. The test program prints it when it starts.
uint64_t test_seed();

}  // namespace stereo::test
