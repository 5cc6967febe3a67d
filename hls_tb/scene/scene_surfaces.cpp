// SPDX-License-Identifier: Apache-2.0
#include "scene/scene_surfaces.hpp"

#include <algorithm>
#include <cmath>

#include "scene/random.hpp"
#include "scene/scene.hpp"

namespace stereo {
namespace {

/// A random value 0 ... 1 for every point of a grid.
double grid_noise(int64_t x, int64_t y, uint64_t seed) {
   return double(mix_bits(mix_bits(seed ^ uint64_t(x)) ^ uint64_t(y)) >> 40) / double(1 << 24);
}

/// The grid's values, joined smoothly; `scale` is the distance of its points.
double smooth_noise(double x, double y, double scale, uint64_t seed) {
   x /= scale;
   y /= scale;
   const double column = std::floor(x), row = std::floor(y);
   const auto ease = [](double t) { return t * t * (3 - 2 * t); };
   const double u = ease(x - column), v = ease(y - row);
   const auto corner = [&](int dx, int dy) { return grid_noise(int64_t(column) + dx, int64_t(row) + dy, seed); };
   const double above = corner(0, 0) * (1 - u) + corner(1, 0) * u;
   const double below = corner(0, 1) * (1 - u) + corner(1, 1) * u;
   return above * (1 - v) + below * v;
}

/// From fine grain, which makes every pixel's surroundings unique, to coarse stains. -1 ... 1
double texture(double x, double y, uint64_t seed) {
   const double grain = smooth_noise(x, y, 1.7, seed);
   const double fibre = smooth_noise(x, y, 5, seed + 1);
   const double stain = smooth_noise(x, y, 23, seed + 2);
   return 2 * (0.45 * grain + 0.3 * fibre + 0.25 * stain) - 1;
}

/// Tiles in perspective. `depth` is 1 at the horizon, where a tile is `size` pixels wide. -1 ... 1
double tiles(double x, double depth, double size) {
   constexpr double kPi = 3.14159265358979;
   const double value = 4 * std::sin(kPi * x * depth / size) * std::sin(kPi * 9 * depth);
   return std::clamp(value, -1.0, 1.0);
}

/// Runs up and down between 0 and 1.
double swing(double value) {
   const double place = value - 2 * std::floor(value / 2);
   return place > 1 ? 2 - place : place;
}

/// Changes in a frame, of what lies between 0 and 1.
struct Motion {
   double drift = 0;     ///< of the place in a row
   double approach = 0;  ///< of the place in the range of disparities

   explicit Motion(Random random) : drift(random.between(-0.02, 0.02)), approach(random.between(-0.04, 0.04)) {}
};

/// 0 in frame 0, to the last bit.
double shift(double start, double change, int frames) { return swing(start + change * frames) - swing(start); }

/// Where boxes and balls stand.
struct Ground {
   const Surface& floor;
   double seen, far, near;  ///< columns; disparities

   double disparity_at(double depth) const { return far + depth * (near - far); }

   Surface standing(Shape shape, double x, double size, double aspect, double disparity) const {
      Surface object;
      object.shape = shape;
      object.disparity = std::round(disparity);
      object.half_width = size;
      object.half_height = size * aspect;
      object.centre_x = x;
      const double ground = floor.centre_y + (object.disparity - floor.disparity) / floor.slope_y;
      object.centre_y = ground - object.half_height;
      return object;
   }

   /// x, size and depth as they are when it starts to move. What comes near grows.
   Surface moving(Shape shape, double x, double size, double aspect, double depth, Motion motion, int frames) const {
      const double first_disparity = disparity_at(depth),
                   disparity = disparity_at(depth + shift(depth, motion.approach, frames));
      const Surface first = standing(shape, x, size, aspect, first_disparity);
      const double growth = disparity / first_disparity;
      Surface object =
          standing(shape, x + seen * shift(x / seen, motion.drift, frames), size * growth, aspect, disparity);
      object.growth = growth;
      object.moved_x = object.centre_x - first.centre_x;
      object.moved_y = object.centre_y - first.centre_y;
      return object;
   }
};

}  // namespace

bool Surface::contains(double x, double y) const {
   const double u = (x - centre_x) / half_width, v = (y - centre_y) / half_height;
   switch (shape) {
      case Shape::box:
         return std::abs(u) <= 1 && std::abs(v) <= 1;
      case Shape::disc:
         return u * u + v * v <= 1;
      case Shape::floor:
         return y >= centre_y;
      case Shape::everywhere:
         break;
   }
   return true;
}

double Surface::shade(double x, double y) const {
   double light = brightness;
   const double u = (x - centre_x) / half_width, v = (y - centre_y) / half_height;
   if (shape == Shape::disc) {  // lit like a ball, from the upper left
      const double towards_us = std::sqrt(std::max(0.0, 1 - u * u - v * v));
      light *= 0.35 + 0.75 * std::max(0.0, 0.7 * towards_us - 0.45 * u - 0.55 * v);
   } else if (shape == Shape::box) {  // a dark frame
      light *= std::max(std::abs(u), std::abs(v)) > 0.88 ? 0.6 : 1.0 - 0.15 * v;
   } else if (shape == Shape::floor) {
      light *= 1 + 0.3 * tiles(x - centre_x, disparity / disparity_at(x, y), half_width);
   } else {
      light *= 1 - 0.25 * v;
   }
   const auto at_first = [this](double at, double centre, double moved) {
      return at - moved + (at - centre) * (1 / growth - 1);
   };
   return light + 0.5 * contrast * texture(at_first(x, centre_x, moved_x), at_first(y, centre_y, moved_y), seed);
}

std::vector<Surface> arrange_surfaces(int width, int height, int disparities, uint64_t seed, int frame) {
   Random random(seed);
   const double far = std::max(1.0, std::round(0.12 * disparities)), near = 0.93 * (disparities - 1);
   const double seen = width - 0.8 * disparities;  // the columns that a disparity map shows, and a few more
   std::vector<Surface> scene;
   const auto add = [&](Surface surface, double brightness, double contrast) {
      surface.brightness = brightness;
      surface.contrast = contrast;
      surface.seed = mix_bits(seed * 64 + scene.size());
      scene.push_back(surface);
   };

   Surface wall;
   wall.disparity = far;
   wall.centre_x = seen / 2;
   wall.centre_y = 0.3 * height;
   wall.half_width = width;
   wall.half_height = height;
   add(wall, 0.62, 0.5);

   Surface floor;
   floor.shape = Shape::floor;
   floor.centre_x = seen * random.between(0.35, 0.65);
   floor.centre_y = height * random.between(0.42, 0.5);
   floor.half_width = 0.03 * seen;
   floor.disparity = far;
   floor.slope_y = std::max(1e-6, near - far) / (height - floor.centre_y);
   add(floor, 0.5, 0.45);

   Surface board;  // leans away from the viewer to one side
   board.shape = Shape::box;
   const bool left_side = random.percent(50);
   board.centre_x = seen * (left_side ? 0.2 : 0.8);
   board.centre_y = 0.3 * height;
   board.half_width = 0.16 * seen;
   board.half_height = 0.22 * height;
   board.disparity = far + 0.2 * (near - far);
   board.slope_x = (left_side ? -1 : 1) * std::min(0.4, 0.14 * (near - far) / board.half_width);
   add(board, 0.8, 0.6);

   const Ground ground{floor, seen, far, near};
   constexpr int kObjects = 6;
   const double lane = seen / kObjects;
   const int first_lane = random.below(kObjects);
   for (int i = 0; i < kObjects; ++i) {  // far to near, spread over the lanes
      const double depth = 0.1 + 0.75 * (i + random.between(0, 0.6)) / kObjects;
      const double x = lane * ((first_lane + i * 5) % kObjects + random.between(0.3, 0.7));
      const double size = std::min(width, 2 * height) * (0.04 + 0.075 * depth) * random.between(0.85, 1.15);
      const bool ball = (i + first_lane) % 2 == 0;
      const double aspect = ball ? 1 : random.between(1.0, 1.7);
      const Motion motion(Random(mix_bits(seed) + uint64_t(i)));
      const double contrast = random.between(0.45, 0.7), brightness = random.between(0.35, 0.9);
      add(ground.moving(ball ? Shape::disc : Shape::box, x, size, aspect, depth, motion, frame), brightness, contrast);
   }
   if (frame >= kNewObjectFrames) {
      const uint64_t number = uint64_t(frame / kNewObjectFrames), its_seed = mix_bits(mix_bits(seed) - number);
      Random its(its_seed);
      const Shape shape = its.percent(50) ? Shape::disc : Shape::box;
      const double x = seen * its.between(0.15, 0.85), depth = its.between(0.1, 1);
      const double size = std::min(width, 2 * height) * its.between(0.06, 0.12);
      add(ground.moving(shape, x, size, 1, depth, Motion(its), frame % kNewObjectFrames), 0.6, 0.6);
      scene.back().seed = its_seed;
   }
   return scene;
}

}  // namespace stereo
