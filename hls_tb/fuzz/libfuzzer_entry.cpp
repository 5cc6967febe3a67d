// SPDX-License-Identifier: Apache-2.0
// What libFuzzer calls, for the target STEREO_FUZZ_TARGET.
#include <cstddef>
#include <cstdint>

#include "fuzz/targets.hpp"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, std::size_t size) {
   stereo::fuzz::STEREO_FUZZ_TARGET({reinterpret_cast<const char*>(data), size});
   return 0;
}
