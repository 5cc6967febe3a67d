// SPDX-License-Identifier: Apache-2.0
#include "program/io/child_process.hpp"

#include <gtest/gtest.h>
#include <sys/time.h>

#include <csignal>
#include <stdexcept>
#include <thread>

namespace stereo::app {
namespace {

using namespace std::chrono_literals;

TEST(ChildProcess, ReturnsWhatTheWorkReturned) {
   const std::string large(1 << 20, 'x');  // more than a pipe holds
   EXPECT_EQ(done_by_child([&] { return large; }, 60s), large);
   EXPECT_EQ(done_by_child([] { return std::string(); }, 60s), "");
}

TEST(ChildProcess, NothingOfWorkThatThrowsCrashesOrEnds) {
   EXPECT_EQ(done_by_child([]() -> std::string { throw std::runtime_error("no"); }, 60s), std::nullopt);
   EXPECT_EQ(done_by_child(
                 []() -> std::string {
                    std::raise(SIGSEGV);
                    return "survived";
                 },
                 60s),
             std::nullopt);
   EXPECT_EQ(done_by_child([]() -> std::string { std::abort(); }, 60s), std::nullopt);
}

TEST(ChildProcess, NothingOfWorkThatIsNotDoneInTime) {
   const auto start = std::chrono::steady_clock::now();
   const auto endless = []() -> std::string {
      for (;;) std::this_thread::sleep_for(1h);
   };
   EXPECT_EQ(done_by_child(endless, 50ms), std::nullopt);
   EXPECT_LT(std::chrono::steady_clock::now() - start, 30s);
}

TEST(ChildProcess, SignalsToTheParentChangeNothing) {
   struct sigaction old {
   }, counted{};
   static volatile std::sig_atomic_t signals = 0;
   counted.sa_handler = [](int) { signals = signals + 1; };  // without SA_RESTART
   sigaction(SIGALRM, &counted, &old);
   const itimerval often{{0, 20000}, {0, 20000}}, never{};
   setitimer(ITIMER_REAL, &often, nullptr);
   const auto slow = [] {
      std::this_thread::sleep_for(300ms);
      return std::string("done");
   };
   EXPECT_EQ(done_by_child(slow, 60s), "done");
   setitimer(ITIMER_REAL, &never, nullptr);
   sigaction(SIGALRM, &old, nullptr);
   EXPECT_GT(signals, 3);
}

}  // namespace
}  // namespace stereo::app
