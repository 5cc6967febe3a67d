// SPDX-License-Identifier: Apache-2.0
#include "program/io/child_process.hpp"

#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <stdexcept>
#include <string_view>

namespace stereo::app {
namespace {

using Clock = std::chrono::steady_clock;

bool write_all(int descriptor, std::string_view bytes) {
   while (!bytes.empty()) {
      const ssize_t count = write(descriptor, bytes.data(), bytes.size());
      if (count <= 0) return false;
      bytes.remove_prefix(std::size_t(count));
   }
   return true;
}

/// Crashes end the child in silence: no handler, no core file.
[[noreturn]] void be_the_child(const std::function<std::string()>& work, int descriptor) {
   for (const int crash : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT}) std::signal(crash, SIG_DFL);
   const rlimit none{0, 0};
   setrlimit(RLIMIT_CORE, &none);
   bool done = false;
   try {
      done = write_all(descriptor, work());
   } catch (...) {
      done = false;
   }
   _exit(done ? 0 : 1);
}

/// All bytes up to their end; nothing when that does not come in time.
std::optional<std::string> read_all(int descriptor, Clock::time_point end) {
   std::string bytes;
   std::array<char, 4096> part{};
   for (;;) {
      const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - Clock::now()).count();
      pollfd waiting{descriptor, POLLIN, 0};
      if (left <= 0) return std::nullopt;
      if (poll(&waiting, 1, int(left)) <= 0) continue;  // too late, or a signal
      const ssize_t count = read(descriptor, part.data(), part.size());
      if (count == 0) return bytes;
      if (count > 0) bytes.append(part.data(), std::size_t(count));
   }
}

}  // namespace

std::optional<std::string> done_by_child(const std::function<std::string()>& work, std::chrono::milliseconds limit) {
   std::array<int, 2> ends{};
   if (pipe(ends.data()) != 0) throw std::runtime_error("there is no pipe for a child process");
   const auto [out, in] = ends;
   const pid_t child = fork();
   if (child == 0) {
      close(out);
      be_the_child(work, in);
   }
   close(in);
   if (child < 0) {
      close(out);
      throw std::runtime_error("there is no child process");
   }
   std::optional<std::string> answer = read_all(out, Clock::now() + limit);
   close(out);
   if (!answer) kill(child, SIGKILL);
   int status = 0;
   while (waitpid(child, &status, 0) < 0 && errno == EINTR) continue;
   if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) return std::nullopt;
   return answer;
}

}  // namespace stereo::app
