// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>

namespace stereo::app {

/// The result of `work`; `milliseconds` becomes the time that it took.
template <class Work>
auto timed(double& milliseconds, Work work) {
   const auto start = std::chrono::steady_clock::now();
   auto result = work();
   milliseconds = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
   return result;
}

}  // namespace stereo::app
