// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <unistd.h>

#include <chrono>
#include <iomanip>
#include <iostream>

namespace stereo::app {

/// Says how many frames are done: on a terminal always in one line, else a line now and then.
class FrameProgress {
  public:
   void frame_done() {
      ++frames_;
      const double now = seconds(), wait = terminal_ ? 0.2 : 5;
      if (now - said_ < wait) return;
      said_ = now;
      std::cout << (terminal_ ? "\r" : "") << frames_ << " frames, " << std::fixed << std::setprecision(1)
                << frames_ / now << " frames a second" << (terminal_ ? "   " : "\n") << std::flush;
   }
   int frames() const { return frames_; }
   double seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }
   /// Goes before the text that takes the line's place.
   const char* line_start() const { return terminal_ && said_ > 0 ? "\r" : ""; }

  private:
   using Clock = std::chrono::steady_clock;

   Clock::time_point start_ = Clock::now();
   bool terminal_ = isatty(STDOUT_FILENO) == 1;
   double said_ = 0;
   int frames_ = 0;
};

}  // namespace stereo::app
