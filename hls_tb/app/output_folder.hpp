// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace stereo::app {

/// Writes all of a command's files or none: they stand under temporary names until `commit` gives them their own.
class OutputFolder {
  public:
   /// Creates the folder where it is missing. Throws InputError, which names the option, when that fails.
   explicit OutputFolder(const std::string& path, const std::string& option = "--out");
   /// Removes what was not committed.
   ~OutputFolder();
   OutputFolder(const OutputFolder&) = delete;
   OutputFolder& operator=(const OutputFolder&) = delete;

   /// Throws InputError when the file cannot be written or replaced.
   void add(const std::string& name, const std::string& content);
   /// Prints the files' paths on stdout.
   void commit();

  private:
   std::filesystem::path temporary(const std::string& name) const;

   std::filesystem::path path_;
   std::string option_;
   std::vector<std::string> names_;
};

}  // namespace stereo::app
