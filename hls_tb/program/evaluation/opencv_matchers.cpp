// SPDX-License-Identifier: Apache-2.0
#include "program/evaluation/opencv_matchers.hpp"

#include <algorithm>
#include <opencv2/calib3d.hpp>

#include "program/errors.hpp"
#include "program/io/opencv_images.hpp"

namespace stereo::app {
namespace {

constexpr int kLargestRange = 4096;

using Kind = OpenCvMatcher::Kind;

struct Mode {
   int number;  ///< OpenCV's
   const char* word;
   const char* name;
};

const Mode& mode_of(Kind kind) {
   static const std::map<Kind, Mode> modes{
       {Kind::sgbm, {cv::StereoSGBM::MODE_SGBM, "sgbm", "StereoSGBM"}},
       {Kind::sgbm_3way, {cv::StereoSGBM::MODE_SGBM_3WAY, "sgbm_3way", "StereoSGBM, 3WAY"}},
       {Kind::sgbm_hh4, {cv::StereoSGBM::MODE_HH4, "sgbm_hh4", "StereoSGBM, HH4"}},
       {Kind::sgbm_hh, {cv::StereoSGBM::MODE_HH, "sgbm_hh", "StereoSGBM, HH"}}};
   return modes.at(kind);
}

cv::Ptr<cv::StereoMatcher> create(const OpenCvMatcher& matcher) {
   const int block = matcher.block_px, area = block * block;
   if (matcher.kind == Kind::bm) return cv::StereoBM::create(matcher.disparities, block);
   return cv::StereoSGBM::create(0, matcher.disparities, block, 10 * area, 40 * area, 1, 63, 10, 100, 32,
                                 mode_of(matcher.kind).number);
}

}  // namespace

const char* OpenCvMatcher::name() const { return kind == Kind::bm ? "StereoBM" : mode_of(kind).name; }

const std::map<std::string, Kind>& opencv_kinds() {
   static const std::map<std::string, Kind> kinds = [] {
      std::map<std::string, Kind> found{{"bm", Kind::bm}};
      for (const Kind kind : {Kind::sgbm, Kind::sgbm_3way, Kind::sgbm_hh4, Kind::sgbm_hh})
         found[mode_of(kind).word] = kind;
      return found;
   }();
   return kinds;
}

nlohmann::json parameters_json(const OpenCvMatcher& matcher) {
   const cv::Ptr<cv::StereoMatcher> made = create(matcher);
   nlohmann::json json{
       {"disparities", made->getNumDisparities()},          {"block_px", made->getBlockSize()},
       {"min_disparity", made->getMinDisparity()},          {"disp12_max_diff", made->getDisp12MaxDiff()},
       {"speckle_window_px", made->getSpeckleWindowSize()}, {"speckle_range", made->getSpeckleRange()}};
   if (const auto bm = made.dynamicCast<cv::StereoBM>())
      json.update({{"prefilter", bm->getPreFilterType() == cv::StereoBM::PREFILTER_XSOBEL ? "xsobel" : "normalized"},
                   {"prefilter_cap", bm->getPreFilterCap()},
                   {"texture_threshold", bm->getTextureThreshold()},
                   {"uniqueness_percent", bm->getUniquenessRatio()}});
   if (const auto sgbm = made.dynamicCast<cv::StereoSGBM>())
      json.update({{"p1", sgbm->getP1()},
                   {"p2", sgbm->getP2()},
                   {"prefilter_cap", sgbm->getPreFilterCap()},
                   {"uniqueness_percent", sgbm->getUniquenessRatio()},
                   {"mode", mode_of(matcher.kind).word}});
   return json;
}

void check_opencv_matcher(const OpenCvMatcher& matcher, int width, int height) {
   const std::string name = matcher.name();
   if (matcher.disparities < 16 || matcher.disparities % 16 != 0 || matcher.disparities > kLargestRange)
      throw InputError("--opencv-disparities " + std::to_string(matcher.disparities) + ": " + name +
                       " takes a multiple of 16 from 16 to " + std::to_string(kLargestRange));
   const bool bm = matcher.kind == Kind::bm;
   const int smallest = bm ? 5 : 1, largest = std::min(bm ? 255 : 51, std::min(width, height) - 1);
   if (matcher.block_px % 2 == 0 || matcher.block_px < smallest || matcher.block_px > largest)
      throw InputError("--opencv-block " + std::to_string(matcher.block_px) + ": for images of " +
                       size_text(width, height) + " " + name + " takes an odd block side from " +
                       std::to_string(smallest) + " to " + std::to_string(largest));
}

DisparityImage match_opencv(const ImagePair& pair, const OpenCvMatcher& matcher, int threads) {
   cv::setNumThreads(threads);
   ImagePair copy = pair;
   cv::Mat map;
   create(matcher)->compute(as_mat(copy.left), as_mat(copy.right), map);
   DisparityImage result(pair.left.width, pair.left.height);
   for (int y = 0; y < result.height; ++y)
      for (int x = 0; x < result.width; ++x)
         if (const short value = map.at<short>(y, x); value >= 0)
            result.at(x, y) = float(value) / float(cv::StereoMatcher::DISP_SCALE);
   return result;
}

}  // namespace stereo::app
