// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fcntl.h>
#include <unistd.h>

#include <cstdio>
#include <opencv2/core/utils/logger.hpp>

namespace stereo::app {

/// While it lives, nothing reaches stderr: OpenCV and the libraries under it print complaints of their own; ours says
/// it in one sentence.
class SilentStderr {
  public:
   SilentStderr() : saved_(dup(STDERR_FILENO)) {
      cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT);
      std::fflush(stderr);
      const int nowhere = open("/dev/null", O_WRONLY);
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

  private:
   int saved_;
};

}  // namespace stereo::app
