// SPDX-License-Identifier: Apache-2.0
#include "program/io/image_codecs.hpp"

extern "C" const stereo::app::ImageCodecs stereo_image_module;

namespace stereo::app {

const ImageCodecs& image_codecs() { return stereo_image_module; }

}  // namespace stereo::app
