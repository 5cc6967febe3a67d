// SPDX-License-Identifier: Apache-2.0
#include "program/io/images.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <fstream>
#include <iostream>
#include <opencv2/imgproc.hpp>

#include "definition/pixel_range.hpp"
#include "program/errors.hpp"
#include "program/io/image_codecs.hpp"
#include "program/io/opencv_images.hpp"
#include "program/io/require_file.hpp"

namespace stereo::app {
namespace {

template <class Pixel>
RasterImage<Pixel> cropped(const RasterImage<Pixel>& image, int width, int height) {
   RasterImage<Pixel> result(width, height);
   const int x = (image.width - width) / 2, y = (image.height - height) / 2;
   for (int row = 0; row < height; ++row) std::copy_n(image.row(y + row) + x, width, result.row(row));
   return result;
}

template <class Pixel>
RasterImage<Pixel> resized(RasterImage<Pixel> image, int width, int height) {
   RasterImage<Pixel> result(width, height);
   const bool shrinks = width <= image.width && height <= image.height;
   cv::resize(as_mat(image), as_mat(result), {width, height}, 0, 0, shrinks ? cv::INTER_AREA : cv::INTER_LINEAR);
   return result;
}

/// A PNG of that kind, whose second channel OpenCV drops.
bool is_gray_with_alpha(const std::string& path) {
   constexpr std::size_t kColorType = 25;
   std::array<char, kColorType + 1> head{};
   std::ifstream file(path, std::ios::binary);
   return file.read(head.data(), head.size()) && std::memcmp(head.data(), "\x89PNG", 4) == 0 && head[kColorType] == 4;
}

/// A picture of one plane of a map.
template <class Value, class Shade>
GrayImage gray_of(const std::vector<Value>& plane, const DisparityMap& map, Shade shade) {
   GrayImage image(map.width, map.height);
   std::transform(plane.begin(), plane.end(), image.pixels.begin(), [&](Value value) { return uint8_t(shade(value)); });
   return image;
}

}  // namespace

cv::Mat read_image(const std::string& path, const std::string& name) {
   require_file(path, name);
   cv::Mat mat = image_codecs().read(path);
   if (mat.empty()) throw InputError(name + ": not an image that can be read; give a PNG, PGM, JPEG, BMP or TIFF file");
   return mat;
}

cv::Mat read_8_bit_image(const std::string& path) {
   cv::Mat mat = read_image(path, path);
   if (mat.depth() != CV_8U)
      throw InputError(path + ": has " + std::to_string(8 * mat.elemSize1()) +
                       " bits a channel but must have 8; convert it to an 8-bit image");
   if (mat.channels() != 1 && mat.channels() != 3 && mat.channels() != 4)
      throw InputError(path + ": has " + std::to_string(mat.channels()) +
                       " channels but must be grey or in colour; convert it to a grey image");
   return mat;
}

GrayImage gray_of_any(const cv::Mat& mat) {
   if (mat.channels() == 1) return from_mat(mat);
   cv::Mat gray;
   cv::cvtColor(mat, gray, mat.channels() == 4 ? cv::COLOR_BGRA2GRAY : cv::COLOR_BGR2GRAY);
   return from_mat(gray);
}

cv::Mat colored(const DisparityMap& map, int disparities) {
   const int largest = std::max((disparities - 1) * map.steps_per_pixel(), 1);
   GrayImage shades = gray_of(map.disparity, map, [&](uint16_t value) { return value * 255 / largest; });
   cv::Mat color;
   cv::applyColorMap(as_mat(shades), color, cv::COLORMAP_TURBO);
   GrayImage invalid = gray_of(map.valid, map, [](uint8_t valid) { return valid != 0 ? 0 : 1; });
   color.setTo(cv::Scalar::all(0), as_mat(invalid));
   return color;
}

std::string encode(const cv::Mat& mat) { return image_codecs().encode_png(mat); }

GrayImage load_gray(const std::string& path) {
   const cv::Mat mat = read_8_bit_image(path);
   if (mat.channels() > 1) std::cout << path << ": colour image converted to grey\n";
   if (mat.channels() == 4 || is_gray_with_alpha(path)) std::cout << path << ": its transparency is left out\n";
   return gray_of_any(mat);
}

ImagePair load_pair(const std::string& left_path, const std::string& right_path) {
   ImagePair pair{load_gray(left_path), load_gray(right_path)};
   require_same_size<InputError>(left_path, pair.left, right_path, pair.right);
   return pair;
}

namespace {

/// Grey values of `bits` bits from a file of 8 or 16.
DeepImage load_deep(const std::string& path, int bits) {
   cv::Mat mat = read_image(path, path);
   if (mat.depth() != CV_16U) return widened(load_gray(path));
   if (mat.channels() != 1)
      throw InputError(path + ": has " + std::to_string(mat.channels()) +
                       " channels of 16 bits but must be grey; convert it to a grey image");
   DeepImage image(mat.cols, mat.rows);
   mat.copyTo(as_mat(image));
   if (const std::string problem = beyond_range(image, bits); !problem.empty()) throw InputError(path + ": " + problem);
   return image;
}

template <class Pair>
Pair fitted(Pair pair, int width, int height, Fit fit) {
   const std::string wanted = size_text(width, height), found = size_text(pair.left);
   if (pair.left.width == width && pair.left.height == height) return pair;
   if (fit == Fit::none)
      throw InputError("the images are " + found + " but the configuration takes " + wanted +
                       "; give images of that size, or --fit crop or --fit resize");
   if (fit == Fit::resize) {
      std::cout << "images resized from " << found << " to " << wanted << '\n';
      return {resized(std::move(pair.left), width, height), resized(std::move(pair.right), width, height)};
   }
   if (pair.left.width < width || pair.left.height < height)
      throw InputError("--fit crop: the images are " + found + ", too small to cut " + wanted +
                       " out of them; give larger images or --fit resize");
   std::cout << "images cropped from " << found << " to the central " << wanted << '\n';
   return {cropped(pair.left, width, height), cropped(pair.right, width, height)};
}

}  // namespace

DeepPair load_deep_pair(const std::string& left_path, const std::string& right_path, int bits) {
   DeepPair pair{load_deep(left_path, bits), load_deep(right_path, bits)};
   require_same_size<InputError>(left_path, pair.left, right_path, pair.right);
   return pair;
}

ImagePair shown_pair(const DeepPair& pair, int bits) {
   const auto shown = [bits](const DeepImage& image) {
      GrayImage result(image.width, image.height);
      std::transform(image.pixels.begin(), image.pixels.end(), result.pixels.begin(),
                     [bits](uint16_t pixel) { return uint8_t(pixel >> (bits - 8)); });
      return result;
   };
   return {shown(pair.left), shown(pair.right)};
}

ImagePair fit_pair(ImagePair pair, int width, int height, Fit fit) {
   return fitted(std::move(pair), width, height, fit);
}
DeepPair fit_pair(DeepPair pair, int width, int height, Fit fit) { return fitted(std::move(pair), width, height, fit); }

std::string encode_png(const GrayImage& image) {
   GrayImage copy = image;
   return encode(as_mat(copy));
}

std::string encode_png(const DeepImage& image) {
   DeepImage copy = image;
   return encode(as_mat(copy));
}

std::string encode_png(const DisparityMap& map) {
   if (!map.subpixel) return encode_png(gray_of(map.disparity, map, [](uint16_t value) { return value; }));
   std::vector<uint16_t> copy = map.disparity;
   return encode(cv::Mat(map.height, map.width, CV_16UC1, copy.data()));
}

std::string encode_color_png(const DisparityMap& map, int disparities) { return encode(colored(map, disparities)); }

std::string encode_valid_png(const DisparityMap& map) {
   return encode_png(gray_of(map.valid, map, [](uint8_t valid) { return valid != 0 ? 255 : 0; }));
}

}  // namespace stereo::app
