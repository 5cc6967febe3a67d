// SPDX-License-Identifier: Apache-2.0
#include "program/io/pfm.hpp"

#include "fuzz/map_promises.hpp"

namespace stereo::fuzz {

bool pfm(std::string_view bytes) {
   app::DisparityImage image;
   try {
      image = app::parse_pfm(bytes);
   } catch (const std::invalid_argument& refusal) {
      check_refusal(refusal, "it");
      return false;
   }
   check_map(image);
   return true;
}

}  // namespace stereo::fuzz
