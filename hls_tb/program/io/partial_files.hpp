// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

namespace stereo::app {

/// A file that is not whole yet. It is removed when its owner goes, and when SIGINT, SIGTERM or SIGHUP ends the
/// program.
class PartialFile {
  public:
   explicit PartialFile(std::filesystem::path path);
   ~PartialFile();
   PartialFile(const PartialFile&) = delete;
   PartialFile& operator=(const PartialFile&) = delete;

   const std::filesystem::path& path() const { return path_; }

  private:
   std::filesystem::path path_;
};

}  // namespace stereo::app
