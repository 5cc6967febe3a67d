// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "support/matching_options.hpp"

namespace stereo {

/// What the pixels and values of a disparity map mean, for images of one width.
struct MapGeometry {
   Reference reference;  ///< the image whose pixels have disparities
   int first_column;     ///< column of the reference image at which the map's column 0 stands
   int width;            ///< columns of the map; below 1 when the images are too narrow
   int disparities;      ///< that were searched
   int min_disparity;    ///< what disparity 0 of the map stands for, in pixels
   bool has_check;       ///< pixels can be invalid
};

}  // namespace stereo
