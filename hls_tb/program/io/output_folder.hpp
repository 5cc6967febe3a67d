// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "program/io/made_folders.hpp"
#include "program/io/partial_files.hpp"

namespace stereo::app {

/// Whether a path leads to one of these files or folders, by whatever name.
bool is_one_of(const std::filesystem::path& path, const std::vector<std::string>& files);

/// Writes all of a command's files or none: they stand under temporary names until `commit` gives them their own.
class OutputFolder {
  public:
   /// Creates the folder where it is missing. Throws InputError, which names the option, when that fails.
   /// `inputs`: files that the command reads, which it must not replace; an empty name stands for none.
   explicit OutputFolder(const std::string& path, std::vector<std::string> inputs = {},
                         const std::string& option = "--out");
   /// Removes what was not committed, and the folders that were made for it.
   ~OutputFolder() = default;
   OutputFolder(const OutputFolder&) = delete;
   OutputFolder& operator=(const OutputFolder&) = delete;

   /// Throws InputError when the file cannot be written, or must not be replaced: an input, a folder, a device, a link.
   void add(const std::string& name, const std::string& content);
   void add_json(const std::string& name, nlohmann::json json);
   /// The same with the files of this run as "files", so it comes last. Where an earlier run has left such a file,
   /// `commit` removes what only that run has written; what is an input now stays, and is listed as "kept_files".
   void add_facts(const std::string& name, nlohmann::json json);

   /// Where `commit` is to remove a file of an earlier run.
   void remove(const std::string& name);

   enum class Says { every_path, nothing };
   /// On stdout. Throws std::runtime_error, and writes nothing, where what was printed has not arrived.
   void commit(Says says = Says::every_path);

  private:
   std::filesystem::path temporary(const std::string& name) const;
   std::vector<std::string> files_of_earlier_runs(const std::string& facts) const;

   std::filesystem::path path_;
   std::vector<std::string> inputs_;
   std::string option_;
   MadeFolders made_;
   std::vector<std::string> names_;
   std::vector<std::unique_ptr<PartialFile>> partial_;
   std::vector<std::string> stale_;  ///< names that only an earlier run has written
};

}  // namespace stereo::app
