// SPDX-License-Identifier: Apache-2.0
#include "app/child_process.hpp"

#include <gtest/gtest.h>

#include <csignal>
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

}  // namespace
}  // namespace stereo::app
