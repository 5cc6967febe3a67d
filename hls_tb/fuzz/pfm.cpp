// SPDX-License-Identifier: Apache-2.0
#include "app/pfm.hpp"

#include "fuzz/targets.hpp"

namespace stereo::fuzz {

bool pfm(std::string_view bytes) {
   app::DisparityImage image;
   try {
      image = app::parse_pfm(bytes);
   } catch (const std::invalid_argument& refusal) {
      check_refusal(refusal, "it");
      return false;
   }
   promise(image.width >= 1 && image.height >= 1, "a map has pixels");
   promise(image.px.size() == std::size_t(image.width) * std::size_t(image.height), "a map has all its pixels");
   for (const float value : image.px)
      promise(!app::has_disparity(value) || std::abs(value) <= app::kLargestDisparity, "a disparity is in range");
   return true;
}

}  // namespace stereo::fuzz
