// SPDX-License-Identifier: Apache-2.0
// The option --threads of all commands that run the fast models.
#pragma once

#include <sched.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <string>
#include <thread>

namespace stereo::app {

inline constexpr int kMostThreads = 1024;

/// Those that this process may use, which std::thread::hardware_concurrency does not ask.
inline int all_cores() {
   cpu_set_t cores;
   return sched_getaffinity(0, sizeof cores, &cores) == 0 ? std::clamp(CPU_COUNT(&cores), 1, kMostThreads) : 1;
}

/// `of`: what runs in the threads, for --help.
inline void add_threads_option(CLI::App& command, int& threads, const std::string& of = "the fast model") {
   threads = all_cores();
   command
       .add_option("--threads", threads,
                   "threads of " + of + "; the result does not depend on it; default: all processors")
       ->check(CLI::Range(1, kMostThreads))
       ->capture_default_str();
}

}  // namespace stereo::app
