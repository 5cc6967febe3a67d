// SPDX-License-Identifier: Apache-2.0
#include "scene/scene.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "scene/random.hpp"
#include "scene/scene_surfaces.hpp"

namespace stereo {
namespace {

void check(const SceneOptions& options) {
   const auto require = [](bool condition, const std::string& sentence) {
      if (!condition) throw std::invalid_argument(sentence);
   };
   require(options.disparities >= 2 && options.disparities <= 256,
           "a scene's disparity range is " + std::to_string(options.disparities) + " but must be 2 ... 256");
   require(options.width > options.disparities, "a scene's width is " + std::to_string(options.width) +
                                                    " but must exceed its disparity range " +
                                                    std::to_string(options.disparities));
   require(options.width <= 16384 && options.height >= 1 && options.height <= 16384,
           "a scene must have 1 ... 16384 rows and at most 16384 columns");
   require(options.noise >= 0 && options.noise <= 64,
           "a scene's noise is " + std::to_string(options.noise) + " but must be 0 ... 64");
   require(options.frame >= 0 && options.frame <= 65535,
           "a scene's frame is " + std::to_string(options.frame) + " but must be 0 ... 65535");
}

/// The surface in front at a pixel of the right or the left image, and where it is hit.
struct Hit {
   const Surface* surface = nullptr;
   double x = 0;  ///< in the right image
   double disparity = -1;

   void offer(const Surface& candidate, double right_x, double y) {
      const double candidate_disparity = candidate.disparity_at(right_x, y);
      if (!candidate.contains(right_x, y) || candidate_disparity <= disparity) return;
      surface = &candidate;
      x = right_x;
      disparity = candidate_disparity;
   }
};

Hit hit_right(const std::vector<Surface>& surfaces, double x, double y) {
   Hit hit;
   for (const Surface& surface : surfaces) hit.offer(surface, x, y);
   return hit;
}

Hit hit_left(const std::vector<Surface>& surfaces, double left_x, double y) {
   Hit hit;
   for (const Surface& surface : surfaces) hit.offer(surface, surface.right_x(left_x, y), y);
   return hit;
}

uint8_t grey(const Hit& hit, double y, int noise, Random& random) {
   const int value = int(std::lround(255 * hit.surface->shade(hit.x, y)));
   return uint8_t(std::clamp(value + random.below(2 * noise + 1) - noise, 0, 255));
}

}  // namespace

Scene make_scene(const SceneOptions& options) {
   check(options);
   const std::vector<Surface> surfaces =
       arrange_surfaces(options.width, options.height, options.disparities, options.seed, options.frame);
   Random noise(options.seed + 1 + (uint64_t(options.frame) << 48));
   const GrayImage blank(options.width, options.height);
   Scene scene{{blank, blank}, blank, blank, blank, blank};
   for (int y = 0; y < options.height; ++y) {
      std::vector<const Surface*> in_left, in_right;
      for (int x = 0; x < options.width; ++x) {
         const Hit hit = hit_left(surfaces, x, y);
         scene.images.left.at(x, y) = grey(hit, y, options.noise, noise);
         scene.left_disparity.at(x, y) = uint8_t(std::lround(hit.disparity));
         in_left.push_back(hit.surface);
      }
      for (int x = 0; x < options.width; ++x) {
         const Hit hit = hit_right(surfaces, x, y);
         const int disparity = int(std::lround(hit.disparity));
         scene.images.right.at(x, y) = grey(hit, y, options.noise, noise);
         scene.disparity.at(x, y) = uint8_t(disparity);
         const bool visible = x + disparity < options.width && in_left[std::size_t(x + disparity)] == hit.surface;
         scene.visible.at(x, y) = visible ? 255 : 0;
         in_right.push_back(hit.surface);
      }
      for (int x = 0; x < options.width; ++x) {
         const int right_x = x - scene.left_disparity.at(x, y);
         const bool visible = right_x >= 0 && in_right[std::size_t(right_x)] == in_left[std::size_t(x)];
         scene.left_visible.at(x, y) = visible ? 255 : 0;
      }
   }
   return scene;
}

DeepPair deepened(const ImagePair& pair, int pixel_bits, uint64_t seed) {
   Random noise(seed ^ 0xdee9);
   const int more = pixel_bits - 8;
   const auto of = [&](const GrayImage& image) {
      DeepImage deep(image.width, image.height);
      std::transform(image.pixels.begin(), image.pixels.end(), deep.pixels.begin(),
                     [&](uint8_t pixel) { return uint16_t((pixel << more) + noise.below(1 << more)); });
      return deep;
   };
   DeepImage left = of(pair.left);
   return {std::move(left), of(pair.right)};
}

}  // namespace stereo
