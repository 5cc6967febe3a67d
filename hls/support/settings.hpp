// SPDX-License-Identifier: Apache-2.0
// Settings that a core takes from ports at each start of frame, where its configuration has run_time_settings.
#pragma once

#include <cstdint>
#include <type_traits>

#include "support/full_width.hpp"
#include "support/pixel_bits.hpp"
#include "support/registers.hpp"

namespace stereo {

/// The settings of a family are a list of LIST(PORT): PORT(type, name) for each, in the order of their ports. It makes
/// their structure here and their ports in hls/top/stereo_top.cpp.
#define STEREO_SETTING_MEMBER(type, name) type name = 0;
#define STEREO_SETTING_VISIT(type, name) visit(#name, name);
#define STEREO_SETTINGS_STRUCT(Name, LIST)        \
   struct Name {                                  \
      LIST(STEREO_SETTING_MEMBER)                 \
      template <class Visitor>                    \
      HLS_INLINE void registers(Visitor& visit) { \
         LIST(STEREO_SETTING_VISIT)               \
      }                                           \
   }
/// Of a core with run_time_size, behind the others.
#define STEREO_SETTINGS_OF_SIZE(PORT) PORT(uint16_t, image_width) PORT(uint16_t, image_height)

/// Whether the configuration's settings come from ports; its own are what they are after a reset.
template <const auto& C>
inline constexpr bool kSetAtRunTime = [] {
   if constexpr (requires { C.run_time_settings; }) return C.run_time_settings;
   else return false;
}();

/// Whether the core has ports for settings at all.
template <const auto& C>
inline constexpr bool kHasSettingPorts = [] {
   if constexpr (requires { C.run_time_size; }) return C.run_time_size || C.run_time_settings;
   else return kSetAtRunTime<C>;
}();

/// One setting of a core, as those around it must know it.
struct Setting {
   const char* name;   ///< of the option and of the port
   int bits;           ///< of the port
   int largest;        ///< it is least ... largest; 0: the core has nothing that it sets
   int start;          ///< the option in the configuration
   int least = 0;      ///< the smallest value
   int step = 1;       ///< it is a multiple of it: 1, 2 or 4
   bool held = false;  ///< it may change only while the core is reset; else it counts with each start of frame
};

/// All of a core, in the order of their ports.
struct SettingList {
   static constexpr int kMost = 8;
   Setting setting[kMost] = {};
   int count = 0;

   constexpr void operator()(const char* name, int bits, int largest, int start, int least = 0) {
      setting[count++] = {name, bits, largest, start, least};
   }
   constexpr void held(const char* name, int bits, int largest, int least, int step) {
      setting[count++] = {name, bits, largest, largest, least, step, true};
   }
   constexpr const Setting* begin() const { return setting; }
   constexpr const Setting* end() const { return setting + count; }
};

/// The thresholds of the checks, and what is searched: with full_width, no disparity below the first one nor above the
/// last one. A left/right threshold of D-1 lets every disparity pass.
#define STEREO_SETTINGS_block_matching(PORT) \
   PORT(uint16_t, texture_threshold)         \
   PORT(uint8_t, uniqueness_percent)         \
   PORT(uint8_t, left_right_threshold)       \
   PORT(uint8_t, first_disparity)            \
   PORT(uint8_t, last_disparity)

/// A frame is matched with those that its start of frame brings.
STEREO_SETTINGS_STRUCT(CheckSettings, STEREO_SETTINGS_block_matching);

/// Those of a family, and the size of the images.
template <class Settings>
struct SizedSettings : Settings {
   STEREO_SETTINGS_OF_SIZE(STEREO_SETTING_MEMBER)

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      Settings::registers(visit);
      STEREO_SETTINGS_OF_SIZE(STEREO_SETTING_VISIT)
   }
};

/// Keeps the settings of the frame that comes in. The checks take them over when its first disparity reaches them:
/// until then they have those of the frame that leaves. Config::problem() says which images are too low for that.
template <const auto& C>
struct FrameSettings {
   uint16_t texture_threshold;
   uint8_t uniqueness_percent;
   uint8_t left_right_threshold;
   uint8_t first_disparity, last_disparity;

   HLS_INLINE FrameSettings() { start(*this); }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("texture_threshold", texture_threshold, C.texture_threshold);
      visit("uniqueness_percent", uniqueness_percent, C.uniqueness_percent);
      visit("left_right_threshold", left_right_threshold, C.has_left_right_check() ? C.left_right_threshold : 0);
      if constexpr (kFullWidth<C>) {
         visit("first_disparity", first_disparity, C.first_disparity);
         visit("last_disparity", last_disparity, C.last_searched());
      }
   }

   HLS_INLINE void clock(const CoreInput<C>& in, const CheckSettings& now) {
      const bool starts = in.valid & in.start_of_frame;
      texture_threshold = select<uint16_t>(starts, now.texture_threshold, texture_threshold);
      uniqueness_percent = select<uint8_t>(starts, now.uniqueness_percent, uniqueness_percent);
      left_right_threshold = select<uint8_t>(starts, now.left_right_threshold, left_right_threshold);
      if constexpr (kFullWidth<C>) {
         first_disparity = select<uint8_t>(starts, now.first_disparity, first_disparity);
         last_disparity = select<uint8_t>(starts, now.last_disparity, last_disparity);
      }
   }
};

/// Stands for it where the settings are the configuration's.
struct NoSettings {};

/// A setting that a check has taken over: a register that is there only where settings come from ports.
template <class T>
struct TakenSetting {
   T value;
};
template <const auto& C, class T>
using TakenOver = std::conditional_t<kSetAtRunTime<C>, TakenSetting<T>, NoSettings>;

/// A cost where a path needs it: the configuration's number, or a register that takes over the frame's.
template <bool IsSet, int Start>
struct NumberHere {
   HLS_INLINE int get() const { return Start; }
   HLS_INLINE void take(bool, int) {}
};
template <int Start>
struct NumberHere<true, Start> {
   uint16_t value;

   HLS_INLINE int get() const { return value; }
   HLS_INLINE void take(bool now, uint16_t taken) { value = select<uint16_t>(now, taken, value); }
};

/// What a port brings, or the next value that the core holds.
template <int Least, int Largest>
HLS_INLINE constexpr uint16_t limited(uint16_t value) {
   const uint16_t high = at_most<Largest>(select<uint16_t>(value > Largest, Largest, value));
   return at_most<Largest>(select<uint16_t>(high < Least, Least, high));
}

/// Whether what this tag belongs to is the first disparity of a frame.
template <class Tag>
HLS_INLINE bool is_first_of_frame(const Tag& tag) {
   return tag.valid & tag.output_column & tag.start_of_frame;
}

}  // namespace stereo
