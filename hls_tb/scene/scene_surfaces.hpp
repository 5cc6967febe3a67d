// SPDX-License-Identifier: Apache-2.0
// The parts of a scene: flat textured surfaces. A plane in space is a plane in disparity too, so each one has an exact
// disparity at every point. Coordinates are those of the right image.
#pragma once

#include <cstdint>
#include <vector>

namespace stereo {

enum class Shape { everywhere, box, disc, floor };

struct Surface {
   Shape shape = Shape::everywhere;
   double centre_x = 0, centre_y = 0;       ///< floor: the horizon is at centre_y
   double half_width = 0, half_height = 0;  ///< floor: half_width is the size of its tiles at the horizon
   double disparity = 0;                    ///< at the centre
   double slope_x = 0, slope_y = 0;         ///< change of disparity per pixel; slope_x above -1
   double brightness = 0.5;                 ///< 0 ... 1
   double contrast = 0.5;                   ///< of the texture, 0 ... 1
   uint64_t seed = 0;
   // What has moved carries its texture along.
   double moved_x = 0, moved_y = 0;  ///< of the centre, since frame 0
   double growth = 1;                ///< size beside that in frame 0

   bool contains(double x, double y) const;
   double disparity_at(double x, double y) const {
      return disparity + slope_x * (x - centre_x) + slope_y * (y - centre_y);
   }
   /// Where the right image shows what the left image shows at (left_x, y).
   double right_x(double left_x, double y) const {
      return (left_x - disparity - slope_y * (y - centre_y) + slope_x * centre_x) / (1 + slope_x);
   }
   /// Grey value 0 ... 1 before clipping; smooth, so that it may be taken between pixels.
   double shade(double x, double y) const;
};

/// All surfaces of a frame, see SceneOptions::frame. `disparities` bounds them: every disparity is above 0 and,
/// rounded, below `disparities`.
std::vector<Surface> arrange_surfaces(int width, int height, int disparities, uint64_t seed, int frame = 0);

}  // namespace stereo
