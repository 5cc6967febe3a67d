// SPDX-License-Identifier: Apache-2.0
// OpenCV's view of our images, for the files that call OpenCV.
#pragma once

#include <opencv2/core/mat.hpp>
#include <string>

#include "definition/disparity_map.hpp"
#include "definition/gray_image.hpp"
#include "program/io/images.hpp"

namespace stereo::app {

/// A view of the pixels, not a copy.
cv::Mat as_mat(GrayImage& image);
cv::Mat as_mat(DeepImage& image);
/// A copy of 8 bits and one channel.
GrayImage from_mat(const cv::Mat& mat);
/// The same of 16 bits.
DeepImage deep_from_mat(const cv::Mat& mat);
/// An image file as it is: any channels, any depth. Throws InputError with one sentence that begins with `name`; the
/// image libraries under OpenCV print nothing.
cv::Mat read_image(const std::string& path, const std::string& name);
/// The same, refused unless it has 1, 3 or 4 channels of 8 bits.
cv::Mat read_8_bit_image(const std::string& path);
/// The same or, where `bits` is more than 8, an image of 16 bits and one channel whose grey values have no more.
cv::Mat read_camera_image(const std::string& path, int bits);
/// An image of 8 bits and 1, 3 or 4 channels in grey.
GrayImage gray_of_any(const cv::Mat& mat);
/// What `read_camera_image` gave, in grey.
AnyPair gray_pair(const cv::Mat& left, const cv::Mat& right);
/// What `read_camera_image` gave, to be looked at: an image of 8 bits as it is, the upper 8 bits of others.
cv::Mat shown_image(const cv::Mat& mat, int bits);
/// A disparity map in colour, from blue for 0 to red for disparities-1 pixels, black where it is not valid.
cv::Mat colored(const DisparityMap& map, int disparities);
/// The bytes of a PNG file.
std::string encode(const cv::Mat& mat);
/// The same of a TIFF file.
std::string encode_tiff(const cv::Mat& mat);

}  // namespace stereo::app
