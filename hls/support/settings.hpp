// SPDX-License-Identifier: Apache-2.0
// Settings that a core takes from ports at each start of frame, where its configuration has run_time_settings.
//
// A family's settings are rows, in the order of their ports:
//
//    #define STEREO_SETTINGS_trellis(SETTING)
//       SETTING(uint8_t, drop_cost, Clamped, true, 0, C.drop_cost, C.drop_cost)
//       SETTING(uint8_t, occlusion_cost, Clamped, true, 1, C.occlusion_cost, C.occlusion_cost)
//    STEREO_DEFINE_SETTINGS(STEREO_SETTINGS_trellis);
//
// Type and name of the port; what the core does with values beyond the limits; whether the core C has the setting; its
// limits; the option of the configuration that it replaces, which is its value after a reset. The name is that of the
// option in Matching, so that the models know it.
#pragma once

#include <cstdint>
#include <type_traits>

#include "support/least_size.hpp"
#include "support/pixel_bits.hpp"
#include "support/registers.hpp"

namespace stereo {

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
   const char* name;      ///< of the option and of the port
   int bits;              ///< of the port
   int largest;           ///< it is least ... largest; 0: the core has nothing that it sets
   int start;             ///< the option in the configuration
   int least = 0;         ///< the smallest value
   int step = 1;          ///< it is a multiple of it: 1, 2 or 4
   bool held = false;     ///< it may change only while the core is reset; else it counts with each start of frame
   bool clamped = false;  ///< the core takes a value beyond the limits as the nearest limit; else none must come
};

/// All of a core, in the order of their ports.
struct SettingList {
   static constexpr int kMost = 12;
   Setting setting[kMost] = {};
   int count = 0;

   constexpr void operator()(const char* name, int bits, bool exists, int largest, int start, int least, bool clamped) {
      if (exists) setting[count++] = {name, bits, largest, start, least, 1, false, clamped};
      else setting[count++] = {name, bits, 0, 0};
   }
   constexpr void held(const char* name, int bits, int largest, int least, int step) {
      setting[count++] = {name, bits, largest, largest, least, step, true};
   }
   constexpr const Setting* begin() const { return setting; }
   constexpr const Setting* end() const { return setting + count; }
};

/// What a port brings, or the next value that the core holds.
template <int Least, int Largest>
HLS_INLINE constexpr uint16_t limited(uint16_t value) {
   const uint16_t high = at_most<Largest>(select<uint16_t>(value > Largest, Largest, value));
   return at_most<Largest>(select<uint16_t>(high < Least, Least, high));
}

// What a setting does with a value that a port shows.
struct AsShown {  ///< those around the core let none pass that is beyond the limits
   static constexpr bool kClamps = false;
   template <int Least, int Largest>
   static HLS_INLINE constexpr uint16_t taken(uint16_t value) {
      return value;
   }
};
struct Masked {  ///< the same, and the core needs just the bits of the largest
   static constexpr bool kClamps = false;
   template <int Least, int Largest>
   static HLS_INLINE constexpr uint16_t taken(uint16_t value) {
      return at_most<Largest>(value);
   }
};
struct Clamped {
   static constexpr bool kClamps = true;
   template <int Least, int Largest>
   static HLS_INLINE constexpr uint16_t taken(uint16_t value) {
      return limited<Least, Largest>(value);
   }
};

// What a row becomes, each in its place.
#define STEREO_SETTING_PORT(type, name, ...) type name = 0;
#define STEREO_SETTING_VISIT(type, name, ...) visit(#name, name);
#define STEREO_SETTING_REGISTER(type, name, ...) type name;
#define STEREO_SETTING_START(type, name, taking, exists, least, largest, start) \
   if constexpr (exists) visit(#name, name, start);
#define STEREO_SETTING_TAKE(type, name, taking, exists, least, largest, start) \
   if constexpr (exists) name = select<type>(starts, type(taking::template taken<least, largest>(now.name)), name);
#define STEREO_SETTING_LIMITS(type, name, taking, exists, least, largest, start) \
   list(#name, 8 * sizeof(type), (exists) && C.run_time_settings, largest, start, least, taking::kClamps);

/// The settings of the namespace's `Config` from their rows. Settings: what the ports bring. FrameSettings: those of
/// the frame that comes in; what needs them takes them over when the frame's first column or disparity reaches it, and
/// until then has those of the frame that leaves. Config::problem() says which images are too low for that.
/// setting_list: what those around the core must know.
// clang-format off
#define STEREO_DEFINE_SETTINGS(ROWS)                                                      \
   struct Settings {                                                                  \
      ROWS(STEREO_SETTING_PORT)                                                       \
                                                                                      \
      template <class Visitor>                                                        \
      HLS_INLINE void registers(Visitor& visit) {                                     \
         ROWS(STEREO_SETTING_VISIT)                                                   \
      }                                                                               \
   };                                                                                 \
   template <const Config& C>                                                         \
   struct FrameSettings {                                                             \
      ROWS(STEREO_SETTING_REGISTER)                                                   \
                                                                                      \
      HLS_INLINE FrameSettings() { start(*this); }                                    \
                                                                                      \
      template <class Visitor>                                                        \
      HLS_INLINE void registers(Visitor& visit) {                                     \
         ROWS(STEREO_SETTING_START)                                                   \
      }                                                                               \
                                                                                      \
      HLS_INLINE void clock(const CoreInput<C>& in, const Settings& now) {            \
         const bool starts = in.valid & in.start_of_frame;                            \
         ROWS(STEREO_SETTING_TAKE)                                                    \
      }                                                                               \
   };                                                                                 \
   constexpr SettingList setting_list(const Config& C) {                              \
      SettingList list;                                                               \
      ROWS(STEREO_SETTING_LIMITS)                                                     \
      visit_size(C, list);                                                            \
      return list;                                                                    \
   }                                                                                  \
   static_assert(true, "for the semicolon")
// clang-format on

// Rows that several families have.
#define STEREO_UNIQUENESS_PERCENT(SETTING) \
   SETTING(uint8_t, uniqueness_percent, AsShown, C.has_uniqueness_check(), 0, 100, C.uniqueness_percent)
/// The left/right check, of which a threshold of D-1 lets every disparity pass; and what is searched: with full_width,
/// no disparity below the first one nor above the last one.
#define STEREO_CHECKED_AND_SEARCHED(SETTING)                                                         \
   SETTING(uint8_t, left_right_threshold, AsShown, C.has_left_right_check(), 0, C.disparities - 1,   \
           C.left_right_threshold)                                                                   \
   SETTING(uint8_t, first_disparity, AsShown, C.full_width, 0, C.disparities - 1, C.first_disparity) \
   SETTING(uint8_t, last_disparity, AsShown, C.full_width, 0, C.disparities - 1,                     \
           C.last_disparity < 0 ? C.disparities - 1 : C.last_disparity)

#define STEREO_SUPPORT_THRESHOLD(SETTING) \
   SETTING(uint8_t, support_threshold, Clamped, C.has_support_filter(), 1, C.kMostNeighbours, C.support_threshold)

/// Of a core with run_time_size, behind the others.
#define STEREO_SETTINGS_OF_SIZE(SETTING) SETTING(uint16_t, image_width) SETTING(uint16_t, image_height)

/// Those of a family, and the size of the images.
template <class Settings>
struct SizedSettings : Settings {
   STEREO_SETTINGS_OF_SIZE(STEREO_SETTING_PORT)

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      Settings::registers(visit);
      STEREO_SETTINGS_OF_SIZE(STEREO_SETTING_VISIT)
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

/// Whether what this tag belongs to is the first disparity of a frame.
template <class Tag>
HLS_INLINE bool is_first_of_frame(const Tag& tag) {
   return tag.valid & tag.output_column & tag.start_of_frame;
}

}  // namespace stereo
