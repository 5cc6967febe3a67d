// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <opencv2/core/utils/logger.hpp>
#include <string>

namespace stereo::app {

/// While it lives, nothing reaches stderr: OpenCV and the libraries under it print complaints of their own; ours says
/// it in one sentence, made of what was `said` where that tells something.
class SilentStderr {
  public:
   SilentStderr() : saved_(dup(STDERR_FILENO)) {
      cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT);
      std::fflush(stderr);
      const int kept = memfd_create("stderr", MFD_CLOEXEC), nowhere = kept >= 0 ? kept : open("/dev/null", O_RDWR);
      dup2(nowhere, STDERR_FILENO);
      close(nowhere);
   }
   ~SilentStderr() {
      std::fflush(stderr);
      dup2(saved_, STDERR_FILENO);
      close(saved_);
   }
   SilentStderr(const SilentStderr&) = delete;
   SilentStderr& operator=(const SilentStderr&) = delete;

   /// The beginning of what would have reached stderr.
   std::string said() const {
      std::array<char, 512> text{};
      std::fflush(stderr);
      const ssize_t count = pread(STDERR_FILENO, text.data(), text.size(), 0);
      return {text.data(), count > 0 ? std::size_t(count) : 0};
   }

  private:
   int saved_;
};

}  // namespace stereo::app
