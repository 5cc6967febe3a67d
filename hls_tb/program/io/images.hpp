// SPDX-License-Identifier: Apache-2.0
// Image files in and out. OpenCV does it, and only inside.
#pragma once

#include <string>
#include <variant>

#include "definition/disparity_map.hpp"
#include "definition/gray_image.hpp"

namespace stereo::app {

/// A pair of 8 bits where neither image has more.
using AnyPair = std::variant<ImagePair, DeepPair>;

/// An 8-bit grey image; a colour image is converted, and stdout says so. Throws InputError.
GrayImage load_gray(const std::string& path);

/// Two images of the same size. Throws InputError.
ImagePair load_pair(const std::string& left_path, const std::string& right_path);
/// The same with grey values of `bits` bits, as they are: an image of 16 bits must have no larger ones, one of 8 bits
/// has none.
DeepPair load_deep_pair(const std::string& left_path, const std::string& right_path, int bits);
/// The same with as few bits as the files have. `bits` of 8: refuses files of 16.
AnyPair load_any_pair(const std::string& left_path, const std::string& right_path, int bits);
/// Its upper 8 bits, to be looked at.
ImagePair shown_pair(const DeepPair& pair, int bits);
inline const ImagePair& shown_pair(const ImagePair& pair, int) { return pair; }
ImagePair shown_pair(const AnyPair& pair, int bits);

enum class Fit { none, crop, resize };

/// The pair at width x height. `none` throws InputError unless it has that size; `crop` takes the centre of a pair that
/// is large enough; `resize` scales. What was done goes to stdout.
ImagePair fit_pair(ImagePair pair, int width, int height, Fit fit);
DeepPair fit_pair(DeepPair pair, int width, int height, Fit fit);

std::string encode_png(const GrayImage& image);
/// 16 bits a pixel.
std::string encode_png(const DeepImage& image);
/// The disparities as they are: 8 bits, or 16 bits where they are sixteenths of a pixel.
std::string encode_png(const DisparityMap& map);
/// A disparity map in colour, from blue for 0 to red for disparities-1 pixels, black where it is not valid.
std::string encode_color_png(const DisparityMap& map, int disparities);
/// 255 where the map is valid, else 0.
std::string encode_valid_png(const DisparityMap& map);
/// 255 where a pixel was filled, else 0.
std::string encode_filled_png(const DisparityMap& map);

}  // namespace stereo::app
