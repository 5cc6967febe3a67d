// SPDX-License-Identifier: Apache-2.0
#include "program/evaluation/measures.hpp"

namespace stereo::app {

Measures measure(const DisparityImage& found, const DisparityImage& truth, const GrayImage& mask) {
   Measures result;
   for (std::size_t i = 0; i < truth.px.size(); ++i) {
      if (mask.pixels[i] == 0 || !has_disparity(truth.px[i])) continue;
      ++result.pixels;
      if (!has_disparity(found.px[i])) continue;
      ++result.valid;
      const float error = std::abs(found.px[i] - truth.px[i]);
      result.error_sum_px += double(error);
      result.squared_error_sum_px2 += double(error) * double(error);
      for (std::size_t t = 0; t < kBadThresholds.size(); ++t) result.bad[t] += error > kBadThresholds[t] ? 1 : 0;
      result.d1 += error > kD1Pixels && error > kD1Share * std::abs(truth.px[i]) ? 1 : 0;
   }
   return result;
}

}  // namespace stereo::app
