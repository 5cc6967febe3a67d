// SPDX-License-Identifier: Apache-2.0
#include "program/io/image_codecs.hpp"
#include "program/io/program_module.hpp"

namespace stereo::app {

const ImageCodecs& image_codecs() {
   static const ImageCodecs& codecs = program_module<ImageCodecs>("stereo_hls_images.so", kImageModuleEntry);
   return codecs;
}

}  // namespace stereo::app
