// SPDX-License-Identifier: Apache-2.0
#pragma once

/// A row of a family's table of configurations, in its namespace `configurations`: its name, what it is there for, the
/// row that it starts from (or `Config()`), and the members that differ, as assignments. CMake reads the rows, too, so
/// each begins a line.
#define STEREO_ROW(name, use, base, ...)                                          \
   struct name##_row : Config {                                                   \
      constexpr name##_row() : Config(base) { static_cast<void>((__VA_ARGS__)); } \
   };                                                                             \
   inline constexpr Config name = name##_row()
