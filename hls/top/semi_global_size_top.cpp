// SPDX-License-Identifier: Apache-2.0
// The hardware top of semi-global matching with a run-time size: that of semi_global_settings_top.cpp, and the ports of
// the size. Where the other settings are constants, their ports are there, too, and say nothing.
//    -DSTEREO_FAMILY=semi_global -DSTEREO_CONFIGURATION=tiny_sgm_size
#define STEREO_TEXT(words) #words
// clang-format off
#define STEREO_HEADER(name) STEREO_TEXT(name/family.hpp)
// clang-format on

#include STEREO_HEADER(STEREO_FAMILY)
#include "support/pixel_bits.hpp"

namespace {
constexpr const auto& kConfig = stereo::STEREO_FAMILY::configurations::STEREO_CONFIGURATION;
constexpr int kPixels = kConfig.pixels_per_clock;
using Core = stereo::STEREO_FAMILY::Core<stereo::STEREO_FAMILY::configurations::STEREO_CONFIGURATION>;
using Pixels = stereo::uint_of_bits<stereo::kPixelBits<kConfig> * kPixels>;
using Disparities = stereo::uint_of_bits<kConfig.disparity_bits() * kPixels>;

// Static, so that they start with zeros in hardware too.
template <class Word, int Depth, int Number>
Word memory_words[Depth];

struct Memories {
   template <class Word, int Depth, int Number>
   HLS_INLINE Word (&words())[Depth] {
      return memory_words<Word, Depth, Number>;
   }
};
}  // namespace

/// Pixels and disparities as in stereo_top.cpp.
#pragma HLS interface port = left_pixel mode = none
#pragma HLS interface port = right_pixel mode = none
#pragma HLS interface port = start_of_frame mode = none
#pragma HLS interface port = valid mode = none
#pragma HLS interface port = p1 mode = none
#pragma HLS interface port = p2 mode = none
#pragma HLS interface port = uniqueness_distance mode = none
#pragma HLS interface port = left_right_threshold mode = none
#pragma HLS interface port = first_disparity mode = none
#pragma HLS interface port = last_disparity mode = none
#pragma HLS interface port = image_width mode = none
#pragma HLS interface port = image_height mode = none
#pragma HLS interface port = disparity mode = none
#pragma HLS interface port = pixel_valid mode = none
#pragma HLS interface port = disparity_valid mode = none
#pragma HLS interface port = disparity_start_of_frame mode = none
#pragma HLS interface port = disparity_end_of_line mode = none
extern "C" void stereo_core(volatile Pixels* left_pixel, volatile Pixels* right_pixel, volatile bool* start_of_frame,
                            volatile bool* valid, volatile uint16_t* p1, volatile uint16_t* p2,
                            volatile uint16_t* uniqueness_distance, volatile uint8_t* left_right_threshold,
                            volatile uint8_t* first_disparity, volatile uint8_t* last_disparity,
                            volatile uint16_t* image_width, volatile uint16_t* image_height,
                            volatile Disparities* disparity, volatile uint8_t* pixel_valid,
                            volatile bool* disparity_valid, volatile bool* disparity_start_of_frame,
                            volatile bool* disparity_end_of_line) {
   Memories memories;
   Core core(memories);
#pragma nounroll
   while (true) {
      // Volatile accesses keep their order, and a read after a write or after the core's memory accesses costs a state:
      // all inputs first, then all outputs, then the clock.
      const Pixels left = *left_pixel;
      const Pixels right = *right_pixel;
      stereo::CoreInput<kConfig> in;
      in.start_of_frame = *start_of_frame;
      in.valid = *valid;
      Core::Settings settings;
      settings.p1 = *p1;
      settings.p2 = *p2;
      settings.uniqueness_distance = *uniqueness_distance;
      settings.left_right_threshold = *left_right_threshold;
      settings.first_disparity = *first_disparity;
      settings.last_disparity = *last_disparity;
      settings.image_width = *image_width;
      settings.image_height = *image_height;
      const stereo::StereoOutput out = core.output();
      Disparities word = 0;
      uint8_t pixels_valid = 0;
      HLS_UNROLL
      for (int p = 0; p < kPixels; ++p) {
         in.left[p] = stereo::pixel_of<kConfig>(left, p);
         in.right[p] = stereo::pixel_of<kConfig>(right, p);
         word |= Disparities(Disparities(out.disparity[p]) << (kConfig.disparity_bits() * p));
         pixels_valid |= uint8_t(uint8_t(out.pixel_valid[p]) << p);
      }
      *disparity = word;
      *pixel_valid = pixels_valid;
      *disparity_valid = out.valid;
      *disparity_start_of_frame = out.start_of_frame;
      *disparity_end_of_line = out.end_of_line;
      core.clock(in, settings);
   }
}
