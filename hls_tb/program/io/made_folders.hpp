// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <unistd.h>

#include <filesystem>
#include <system_error>

namespace stereo::app {

/// Makes a folder and those above it that are missing. The destructor removes those that it made as far as they are
/// empty: a command that fails leaves none behind.
class MadeFolders {
  public:
   /// An empty path stands for the current folder.
   explicit MadeFolders(const std::filesystem::path& path) : path_(path) {
      std::error_code ignored;
      for (std::filesystem::path above = path; !above.empty(); above = above.parent_path()) {
         if (std::filesystem::symlink_status(above, ignored).type() != std::filesystem::file_type::not_found) break;
         outermost_ = above;
      }
      if (!path.empty()) std::filesystem::create_directories(path, error_);
   }
   ~MadeFolders() {
      if (outermost_.empty()) return;
      for (std::filesystem::path made = path_;; made = made.parent_path()) {
         rmdir(made.c_str());  // refuses files and folders that hold something
         if (made == outermost_) return;
      }
   }
   MadeFolders(const MadeFolders&) = delete;
   MadeFolders& operator=(const MadeFolders&) = delete;

   /// Why the folder could not be made, if so.
   std::error_code error() const { return error_; }

  private:
   std::filesystem::path path_;
   std::filesystem::path outermost_;  ///< of those that were missing; empty when none was
   std::error_code error_;
};

}  // namespace stereo::app
