// SPDX-License-Identifier: Apache-2.0
// The hardware top: plain ports around one core that never stops. One pass of the loop is one clock.
//    -DSTEREO_FAMILY=block_matching -DSTEREO_CONFIGURATION=ambrosch2007
// Where settings come from ports, -DSTEREO_SETTINGS; with a run-time size, -DSTEREO_SIZE too. With a size alone, the
// ports of the other settings are there and say nothing.
#define STEREO_TEXT(words) #words
// clang-format off
#define STEREO_HEADER(name) STEREO_TEXT(name/family.hpp)
// clang-format on

#include STEREO_HEADER(STEREO_FAMILY)
#include "support/pixel_bits.hpp"
#include "winner/map_group.hpp"

#ifdef STEREO_SETTINGS
#define STEREO_LIST_OF(family) STEREO_LIST(family)
#define STEREO_LIST(family) STEREO_SETTINGS_##family
#define STEREO_FAMILY_SETTINGS(SETTING) STEREO_LIST_OF(STEREO_FAMILY)(SETTING)
#else
#define STEREO_FAMILY_SETTINGS(SETTING)
#endif
#ifdef STEREO_SIZE
#define STEREO_ALL_SETTINGS(SETTING) STEREO_FAMILY_SETTINGS(SETTING) STEREO_SETTINGS_OF_SIZE(SETTING)
#else
#define STEREO_ALL_SETTINGS(SETTING) STEREO_FAMILY_SETTINGS(SETTING)
#endif
#define STEREO_PORT(type, name, ...) volatile type *name,
#define STEREO_READ(type, name, ...) settings.name = *name;

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

/// Pixels: pixel_bits bits each, row p of the group at bit pixel_bits * p. Disparities likewise, with
/// kConfig.disparity_bits(); what the post-processing gives stands above the disparity (LaneLayout). Bit p of
/// pixel_valid belongs to row p. The tool takes no pragma from a macro, so the ports of settings have none: for what is
/// only read that is the same.
#pragma HLS interface port = left_pixel mode = none
#pragma HLS interface port = right_pixel mode = none
#pragma HLS interface port = start_of_frame mode = none
#pragma HLS interface port = valid mode = none
#pragma HLS interface port = disparity mode = none
#pragma HLS interface port = pixel_valid mode = none
#pragma HLS interface port = disparity_valid mode = none
#pragma HLS interface port = disparity_start_of_frame mode = none
#pragma HLS interface port = disparity_end_of_line mode = none
extern "C" void stereo_core(volatile Pixels* left_pixel, volatile Pixels* right_pixel, volatile bool* start_of_frame,
                            volatile bool* valid, STEREO_ALL_SETTINGS(STEREO_PORT) volatile Disparities* disparity,
                            volatile uint8_t* pixel_valid, volatile bool* disparity_valid,
                            volatile bool* disparity_start_of_frame, volatile bool* disparity_end_of_line) {
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
#ifdef STEREO_SETTINGS
      Core::Settings settings;
      STEREO_ALL_SETTINGS(STEREO_READ)
#endif
      const auto out = core.output();
      Disparities word = 0;
      uint8_t pixels_valid = 0;
      HLS_UNROLL
      for (int p = 0; p < kPixels; ++p) {
         in.left[p] = stereo::pixel_of<kConfig>(left, p);
         in.right[p] = stereo::pixel_of<kConfig>(right, p);
         word |= Disparities(stereo::output_lane<kConfig, Disparities>(out, p) << (kConfig.disparity_bits() * p));
         pixels_valid |= uint8_t(uint8_t(out.pixel_valid[p]) << p);
      }
      *disparity = word;
      *pixel_valid = pixels_valid;
      *disparity_valid = out.valid;
      *disparity_start_of_frame = out.start_of_frame;
      *disparity_end_of_line = out.end_of_line;
#ifdef STEREO_SETTINGS
      core.clock(in, settings);
#else
      core.clock(in);
#endif
   }
}
