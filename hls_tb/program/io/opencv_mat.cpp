// SPDX-License-Identifier: Apache-2.0
#include <opencv2/core.hpp>

#include "program/io/opencv_images.hpp"

namespace stereo::app {

cv::Mat as_mat(GrayImage& image) { return {image.height, image.width, CV_8UC1, image.pixels.data()}; }
cv::Mat as_mat(DeepImage& image) { return {image.height, image.width, CV_16UC1, image.pixels.data()}; }

GrayImage from_mat(const cv::Mat& mat) {
   GrayImage image(mat.cols, mat.rows);
   mat.copyTo(as_mat(image));
   return image;
}

DeepImage deep_from_mat(const cv::Mat& mat) {
   DeepImage image(mat.cols, mat.rows);
   mat.copyTo(as_mat(image));
   return image;
}

}  // namespace stereo::app
