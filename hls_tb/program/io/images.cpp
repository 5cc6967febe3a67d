// SPDX-License-Identifier: Apache-2.0
#include "program/io/images.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <fstream>
#include <iostream>
#include <opencv2/imgproc.hpp>
#include <sstream>

#include "definition/pixel_range.hpp"
#include "program/errors.hpp"
#include "program/io/exif.hpp"
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

/// A medical image, whatever stands before its mark: OpenCV's decoder ends the program at a damaged one.
bool is_dicom(const std::string& path) {
   constexpr int kMark = 128;
   std::array<char, 4> mark{};
   std::ifstream file(path, std::ios::binary);
   return file.seekg(kMark).read(mark.data(), mark.size()) && std::memcmp(mark.data(), "DICM", mark.size()) == 0;
}

/// Of an image that was read. Throws InputError where some of it is missing; stdout says what else the decoder says.
void heed(const std::string& name, const std::string& complaint) {
   if (complaint.empty()) return;
   const std::string line = complaint.substr(0, complaint.find('\n'));
   const auto says = [&complaint](const char* words) { return complaint.find(words) != std::string::npos; };
   // Cameras write some bytes too many between the parts of a JPEG file, which nothing is lost by.
   const bool damaged = says("Corrupt JPEG data") && !says("extraneous bytes before marker");
   if (damaged || says("remature end of"))
      throw InputError(name + ": is truncated or damaged (" + line + "); give the whole image");
   std::cout << "warning: " << name << ": " << line << '\n';
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
   if (is_dicom(path))
      throw InputError(name + ": is a DICOM file, which is not read; give a PNG, PGM, JPEG, BMP or TIFF file");
   std::string complaint;
   cv::Mat mat = image_codecs().read(path, complaint);
   if (mat.empty()) throw InputError(name + ": not an image that can be read; give a PNG, PGM, JPEG, BMP or TIFF file");
   heed(name, complaint);
   std::ostringstream bytes;
   bytes << std::ifstream(path, std::ios::binary).rdbuf();
   if (const int orientation = exif_orientation(bytes.view()); orientation != 1)
      throw InputError(name + ": its EXIF data rotates or mirrors it, orientation " + std::to_string(orientation) +
                       ", but pixels are taken as stored; give an upright image, or "
                       "remove that tag");
   return mat;
}

cv::Mat read_8_bit_image(const std::string& path) {
   cv::Mat mat = read_image(path, path);
   if (mat.depth() != CV_8U)
      throw InputError(path + ": has " + std::to_string(8 * mat.elemSize1()) +
                       " bits a channel but must have 8; convert it to an 8-bit image, or take pixel_bits of 10 or 12");
   if (mat.channels() != 1 && mat.channels() != 3 && mat.channels() != 4)
      throw InputError(path + ": has " + std::to_string(mat.channels()) +
                       " channels but must be grey or in colour; convert it to a grey image");
   return mat;
}

cv::Mat read_camera_image(const std::string& path, int bits) {
   if (bits == 8) return read_8_bit_image(path);
   cv::Mat mat = read_image(path, path);
   if (mat.depth() != CV_16U) return read_8_bit_image(path);
   if (mat.channels() != 1)
      throw InputError(path + ": has " + std::to_string(mat.channels()) +
                       " channels of 16 bits but must be grey; convert it to a grey image");
   if (const std::string problem = beyond_range(deep_from_mat(mat), bits); !problem.empty())
      throw InputError(path + ": " + problem);
   return mat;
}

AnyPair gray_pair(const cv::Mat& left, const cv::Mat& right) {
   // An image of 8 bits is taken without scaling, so its grey values would be those of a far darker camera.
   if (left.depth() != right.depth())
      throw InputError("the left image has " + std::to_string(8 * left.elemSize1()) +
                       " bits a channel and the right one " + std::to_string(8 * right.elemSize1()) +
                       "; give both with the same number of bits");
   if (left.depth() == CV_8U) return ImagePair{gray_of_any(left), gray_of_any(right)};
   return DeepPair{deep_from_mat(left), deep_from_mat(right)};
}

cv::Mat shown_image(const cv::Mat& mat, int bits) {
   if (mat.depth() == CV_8U) return mat;
   GrayImage shown = upper_8_bits(deep_from_mat(mat), bits);
   return as_mat(shown).clone();
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
   GrayImage invalid(map.width, map.height);
   for (int y = 0; y < map.height; ++y)
      for (int x = 0; x < map.width; ++x) invalid.at(x, y) = map.has_value_at(x, y) ? 0 : 1;
   color.setTo(cv::Scalar::all(0), as_mat(invalid));
   return color;
}

std::string encode(const cv::Mat& mat) { return image_codecs().encode(mat, ".png"); }
std::string encode_tiff(const cv::Mat& mat) { return image_codecs().encode(mat, ".tiff"); }

namespace {

/// A file in grey; stdout says what of it is left out.
cv::Mat load_camera_image(const std::string& path, int bits) {
   cv::Mat mat = read_camera_image(path, bits);
   if (mat.channels() > 1) std::cout << path << ": colour image converted to grey\n";
   if (mat.channels() == 4 || is_gray_with_alpha(path)) std::cout << path << ": its transparency is left out\n";
   return mat;
}

struct CameraPair {
   cv::Mat left, right;
};

CameraPair load_camera_pair(const std::string& left_path, const std::string& right_path, int bits) {
   CameraPair pair{load_camera_image(left_path, bits), load_camera_image(right_path, bits)};
   require_same_size<InputError>(left_path, pair.left.size(), right_path, pair.right.size());
   return pair;
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

GrayImage load_gray(const std::string& path) { return gray_of_any(load_camera_image(path, 8)); }

ImagePair load_pair(const std::string& left_path, const std::string& right_path) {
   const CameraPair pair = load_camera_pair(left_path, right_path, 8);
   return {gray_of_any(pair.left), gray_of_any(pair.right)};
}

AnyPair load_any_pair(const std::string& left_path, const std::string& right_path, int bits) {
   const CameraPair pair = load_camera_pair(left_path, right_path, bits);
   return gray_pair(pair.left, pair.right);
}

DeepPair load_deep_pair(const std::string& left_path, const std::string& right_path, int bits) {
   AnyPair pair = load_any_pair(left_path, right_path, bits);
   if (const auto* const narrow = std::get_if<ImagePair>(&pair)) return {widened(narrow->left), widened(narrow->right)};
   return std::get<DeepPair>(std::move(pair));
}

ImagePair shown_pair(const DeepPair& pair, int bits) {
   return {upper_8_bits(pair.left, bits), upper_8_bits(pair.right, bits)};
}
ImagePair shown_pair(const AnyPair& pair, int bits) {
   return std::visit([bits](const auto& images) { return ImagePair(shown_pair(images, bits)); }, pair);
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

std::string encode_filled_png(const DisparityMap& map) {
   return encode_png(gray_of(map.filled, map, [](uint8_t filled) { return filled != 0 ? 255 : 0; }));
}

}  // namespace stereo::app
