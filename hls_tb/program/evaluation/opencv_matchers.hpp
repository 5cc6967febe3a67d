// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "definition/gray_image.hpp"
#include "program/io/disparity_image.hpp"

namespace stereo::app {

/// OpenCV's block matchers as its own regression test runs them (modules/calib3d/test/test_stereomatching.cpp), on grey
/// images, the left one as reference. BM: StereoBM::create and its defaults (x-Sobel with cap 31, texture threshold 10,
/// uniqueness 15 %). SGBM: P1 = 10 b^2, P2 = 40 b^2, disp12MaxDiff 1, cap 63, uniqueness 10 %, speckles of 100 pixels
/// and range 32, mode SGBM. The other modes differ in their paths only: 3WAY looks along 3, HH4 along 4, HH along 8.
struct OpenCvMatcher {
   enum class Kind { bm, sgbm, sgbm_3way, sgbm_hh4, sgbm_hh } kind = Kind::bm;
   int disparities = 48;  ///< the stored parameter for Teddy; a multiple of 16
   int block_px = 15;     ///< for Teddy BM 15, SGBM 3; odd, BM 5 ... 255 and below the image's sides

   static OpenCvMatcher stored(Kind kind) { return {kind, 48, kind == Kind::bm ? 15 : 3}; }
   const char* name() const;
};

/// {word of the command line: kind}
const std::map<std::string, OpenCvMatcher::Kind>& opencv_kinds();

/// Everything that OpenCV is told.
nlohmann::json parameters_json(const OpenCvMatcher& matcher);

/// Throws InputError with one sentence when OpenCV would not take these options for an image of this size.
void check_opencv_matcher(const OpenCvMatcher& matcher, int width, int height);

/// In pixels, in steps of a sixteenth. What OpenCV marks as below the smallest disparity has none.
DisparityImage match_opencv(const ImagePair& pair, const OpenCvMatcher& matcher, int threads);

}  // namespace stereo::app
