// SPDX-License-Identifier: Apache-2.0
#include "program/io/pfm.hpp"

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
   promise(image.px.size() == std::size_t(image.width) * std::size_t(image.height), "a map has all its pixels");
   return true;
}

}  // namespace stereo::fuzz
