// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <future>
#include <vector>

namespace stereo::fast {

/// Calls work(0) ... work(count-1), each in a thread of its own, and waits for all of them. What one of them throws
/// comes out of here.
template <class Work>
void in_threads(int count, const Work& work) {
   std::vector<std::future<void>> others;
   for (int number = 1; number < count; ++number)
      others.push_back(std::async(std::launch::async, [&work, number] { work(number); }));
   work(0);
   for (std::future<void>& other : others) other.get();
}

/// Calls work(first, end) for bands of rows that are 0 ... rows-1 together, one band a thread.
template <class Work>
void for_each_band(int rows, int threads, const Work& work) {
   const int bands = std::clamp(threads, 1, std::max(rows, 1));
   const auto start = [&](int band) { return int(std::ptrdiff_t(rows) * band / bands); };
   in_threads(bands, [&](int band) { work(start(band), start(band + 1)); });
}

}  // namespace stereo::fast
