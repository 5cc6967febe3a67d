// SPDX-License-Identifier: Apache-2.0
#include "program/io/partial_files.hpp"

#include <unistd.h>

#include <array>
#include <atomic>
#include <csignal>
#include <system_error>
#include <utility>

namespace stereo::app {
namespace {

constexpr std::array kSignals = {SIGINT, SIGTERM, SIGHUP};

/// Names of files that are there now. More than so many at a time are removed by their owners only.
std::array<std::atomic<const char*>, 64> names;

/// Calls only what a signal handler may call.
extern "C" void remove_partial_files(int signal) {
   for (const std::atomic<const char*>& name : names)
      if (const char* path = name.load()) unlink(path);
   std::signal(signal, SIG_DFL);
   std::raise(signal);
}

bool watch_signals() {
   for (const int signal : kSignals)
      if (std::signal(signal, remove_partial_files) == SIG_IGN) std::signal(signal, SIG_IGN);
   return true;
}

}  // namespace

PartialFile::PartialFile(std::filesystem::path path) : path_(std::move(path)) {
   static const bool watches = watch_signals();
   static_cast<void>(watches);
   for (std::atomic<const char*>& name : names) {
      const char* none = nullptr;
      if (name.compare_exchange_strong(none, path_.c_str())) break;
   }
}

PartialFile::~PartialFile() {
   std::error_code ignored;
   std::filesystem::remove(path_, ignored);
   for (std::atomic<const char*>& name : names) {
      const char* own = path_.c_str();
      if (name.compare_exchange_strong(own, nullptr)) break;
   }
}

}  // namespace stereo::app
