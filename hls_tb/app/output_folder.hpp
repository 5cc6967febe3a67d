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
   /// Removes what was not committed, and the folder if it was new and stays empty.
   ~OutputFolder();
   OutputFolder(const OutputFolder&) = delete;
   OutputFolder& operator=(const OutputFolder&) = delete;

   /// Throws InputError when the file cannot be written or replaced.
   void add(const std::string& name, const std::string& content);
   enum class Says { every_path, nothing };
   void commit(Says says = Says::every_path);  ///< on stdout

  private:
   std::filesystem::path temporary(const std::string& name) const;

   std::filesystem::path path_;
   std::string option_;
   bool is_new_ = false;
   std::vector<std::string> names_;
};

}  // namespace stereo::app
