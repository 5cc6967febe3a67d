// SPDX-License-Identifier: Apache-2.0
// The option --threads of all commands that run the fast models.
#pragma once

#include <CLI/CLI.hpp>
#include <algorithm>
#include <thread>

namespace stereo::app {

inline constexpr int kMostThreads = 1024;

inline int all_cores() { return std::clamp(int(std::thread::hardware_concurrency()), 1, kMostThreads); }

/// `of`: what runs in the threads, for --help.
inline void add_threads_option(CLI::App& command, int& threads, const std::string& of = "the fast model") {
   threads = all_cores();
   command
       .add_option("--threads", threads,
                   "threads of " + of + ", which give the same disparities in any number; default: all cores")
       ->check(CLI::Range(1, kMostThreads))
       ->capture_default_str();
}

}  // namespace stereo::app
