// SPDX-License-Identifier: Apache-2.0
// Which pixels an evaluation counts: the regions of Scharstein and Szeliski, "A Taxonomy and Evaluation of Dense
// Two-Frame Stereo Correspondence Algorithms" (2002), section 5.1, with the rules and constants of OpenCV's own
// regression test, modules/calib3d/test/test_stereomatching.cpp: computeOcclusionBasedMasks, computeDepthDiscontMask,
// computeTextureBasedMasks, getBorderedMask and calcErrors.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "definition/gray_image.hpp"
#include "program/io/disparity_image.hpp"

namespace stereo::app {

inline constexpr int kIgnoredBorder = 10;          ///< EVAL_IGNORE_BORDER, pixels on each side of the image
inline constexpr float kOcclusionThreshold = 1;    ///< EVAL_DISP_THRESH, pixels
inline constexpr float kDiscontinuityGap = 2;      ///< EVAL_DISP_GAP, pixels
inline constexpr int kDiscontinuityWidth = 9;      ///< EVAL_DISCONT_WIDTH, pixels
inline constexpr int kTexturelessWidth = 3;        ///< EVAL_TEXTURELESS_WIDTH, pixels
inline constexpr float kTexturelessThreshold = 4;  ///< EVAL_TEXTURELESS_THRESH, squared grey levels a pixel

// All masks: 255 where the pixel belongs to the region, else 0.

/// Disparities first ... first+count-1.
struct DisparityRange {
   int first, count;
};

/// Of `visible`, the columns from which all disparities of the range, and the one behind it, lead into the other image.
/// In the others no method can look for all of its disparities; OpenCV's maps begin behind as many columns.
GrayImage searchable_mask(const GrayImage& visible, DisparityRange range, Reference side);

/// The pixels that the other image shows too: the other's truth where the disparity leads to is known and not larger
/// (nearer) by more than kOcclusionThreshold. `side`: which image `truth` belongs to.
GrayImage non_occluded_mask(const DisparityImage& truth, const DisparityImage& other, Reference side);

/// Around pixels whose neighbours' disparities differ by more than kDiscontinuityGap, dilated to squares of
/// kDiscontinuityWidth.
GrayImage discontinuity_mask(const DisparityImage& truth);

/// Where the squared horizontal gradient (Sobel/8), averaged over kTexturelessWidth^2, is below kTexturelessThreshold.
GrayImage textureless_mask(const GrayImage& image);

/// In the order of tables.
inline constexpr const char *kNonOccluded = "non_occluded", *kSearchable = "searchable";
inline constexpr std::array<const char*, 5> kMaskNames{"all", kNonOccluded, kSearchable, "discontinuity",
                                                       "textureless"};

struct NamedMask {
   std::string name;  ///< one of kMaskNames
   GrayImage mask;
};

/// The regions of one reference image. `all`: its truth is known, and the pixel is `border_px` or more away from the
/// image's border. The others lie in `all`, need the other image's truth as well and are absent where `other` is null;
/// discontinuity and textureless lie in non_occluded. Without the searchable columns, which depend on the method.
std::vector<NamedMask> evaluation_masks(const GrayImage& image, const DisparityImage& truth,
                                        const DisparityImage* other, Reference side, int border_px);

}  // namespace stereo::app
