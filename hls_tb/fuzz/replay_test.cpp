// SPDX-License-Identifier: Apache-2.0
// Replays fuzz/corpus/: seeds, and every input that has found something.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <vector>

#include "fuzz/targets.hpp"

namespace stereo::fuzz {
namespace {

namespace fs = std::filesystem;

const fs::path kCorpus = fs::path(STEREO_SOURCE_DIR) / "hls_tb" / "fuzz" / "corpus";

std::string bytes_of(const fs::path& path) {
   std::ostringstream bytes;
   bytes << std::ifstream(path, std::ios::binary).rdbuf();
   return bytes.str();
}

class FuzzReplay : public testing::TestWithParam<Target> {};

TEST_P(FuzzReplay, KeptCases) {
   int taken = 0, refused = 0;
   for (const fs::directory_entry& entry : fs::directory_iterator(kCorpus / GetParam().name)) {
      SCOPED_TRACE(entry.path());
      try {
         (GetParam().run(bytes_of(entry.path())) ? taken : refused) += 1;
      } catch (const std::exception& problem) {
         ADD_FAILURE() << entry.path() << ": " << problem.what();
      }
   }
   // Else the reader would not be reached, or nothing behind it.
   EXPECT_GT(taken, 0);
   EXPECT_GT(refused, 0);
}

INSTANTIATE_TEST_SUITE_P(Readers, FuzzReplay, testing::ValuesIn(kTargets),
                         [](const auto& target) { return std::string(target.param.name); });

TEST(FuzzReplay, EveryFolderHasATarget) {
   std::vector<std::string> folders, targets;
   for (const fs::directory_entry& entry : fs::directory_iterator(kCorpus))
      folders.push_back(entry.path().filename().string());
   for (const Target& target : kTargets) targets.emplace_back(target.name);
   std::sort(folders.begin(), folders.end());
   EXPECT_EQ(folders, targets);
}

}  // namespace
}  // namespace stereo::fuzz
