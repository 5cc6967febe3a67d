// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include "definition/gray_image.hpp"
#include "program/io/disparity_image.hpp"

namespace stereo::app {

inline constexpr std::array<float, 4> kBadThresholds{0.5F, 1, 2, 4};  ///< pixels: bad 0.5, bad 1 ...
// The KITTI stereo benchmark's D1: off by more than both.
inline constexpr float kD1Pixels = 3;
inline constexpr float kD1Share = 0.05F;  ///< of the true disparity

/// The measures of Scharstein and Szeliski (2002), section 5.1, and of the KITTI benchmark, over the pixels of a mask.
/// Fractions and means of no pixels are NaN.
struct Measures {
   int64_t pixels = 0;  ///< of the mask that have a true disparity: no other pixel counts anywhere
   int64_t valid = 0;   ///< of those, with a disparity found
   std::array<int64_t, kBadThresholds.size()> bad{};    ///< valid ones off by more than each threshold
   int64_t d1 = 0;                                      ///< valid ones off by more than D1 allows
   double error_sum_px = 0, squared_error_sum_px2 = 0;  ///< of the valid ones

   int64_t bad_by_more_than_1_px() const { return bad[1]; }
   double density() const { return ratio(double(valid), pixels); }
   double average_px() const { return ratio(error_sum_px, valid); }
   double rms_px() const { return std::sqrt(ratio(squared_error_sum_px2, valid)); }
   /// Share of bad pixels when invalid ones count as bad, as OpenCV's test and the KITTI benchmark want it.
   double with_invalid(int64_t bad_ones) const { return ratio(double(bad_ones + pixels - valid), pixels); }
   /// The same when invalid ones are left out.
   double of_valid(int64_t bad_ones) const { return ratio(double(bad_ones), valid); }

  private:
   static double ratio(double part, int64_t whole) { return whole == 0 ? kNoDisparity : part / double(whole); }
};

/// All three have one size; a pixel counts where the mask is not 0 and `truth` has a disparity.
Measures measure(const DisparityImage& found, const DisparityImage& truth, const GrayImage& mask);

}  // namespace stereo::app
