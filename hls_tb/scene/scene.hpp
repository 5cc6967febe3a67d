// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>

#include "definition/gray_image.hpp"

namespace stereo {

struct SceneOptions {
   int width = 640;  ///< above `disparities`
   int height = 480;
   int disparities = 100;  ///< 2 ... 256; the scene's disparities stay below it
   uint64_t seed = 1;
   int noise = 2;  ///< sensor noise: largest deviation in grey levels, 0 ... 64
   /// Of a moving scene, 0 ... 65535: boxes and balls drift, come near and go away. Each kNewObjectFrames frames
   /// another object stands anywhere in the range, and the last such one is gone.
   int frame = 0;
};

inline constexpr int kNewObjectFrames = 5;

/// A rectified pair with its ground truth, seen from the right camera: left(x + disparity) shows what right(x) shows.
struct Scene {
   ImagePair images;
   GrayImage disparity;  ///< of the right image, rounded to whole pixels
   GrayImage visible;    ///< 255 where the left image shows the right image's pixel too, else 0
   // The same of the left image: right(x - left_disparity) shows what left(x) shows.
   GrayImage left_disparity, left_visible;
};

/// A textured wall, a checkered floor and a slanted board with boxes and balls before them; all of it follows from the
/// options. Throws std::invalid_argument with one sentence on options out of range.
Scene make_scene(const SceneOptions& options);

/// The pair as cameras of more bits see it: 8 upper bits as they are, the others noise.
DeepPair deepened(const ImagePair& pair, int pixel_bits, uint64_t seed);

}  // namespace stereo
