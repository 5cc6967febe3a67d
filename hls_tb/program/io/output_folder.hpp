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

/// Writes all of a command's files or none: they stand under temporary names until `commit` gives them their own.
class OutputFolder {
  public:
   /// Creates the folder where it is missing. Throws InputError, which names the option, when that fails.
   explicit OutputFolder(const std::string& path, const std::string& option = "--out");
   /// Removes what was not committed, and the folders that were made for it.
   ~OutputFolder() = default;
   OutputFolder(const OutputFolder&) = delete;
   OutputFolder& operator=(const OutputFolder&) = delete;

   enum class Runs { all, some };
   /// A file that all runs of the command write, or only some. Throws InputError when it cannot be written or replaced.
   void add(const std::string& name, const std::string& content, Runs writers = Runs::all);
   void add_json(const std::string& name, const nlohmann::json& json);
   /// A file that only other runs of the command write: where `commit` replaces a whole result of an earlier run, it
   /// removes this one too. A file of `inputs` stays, whatever its name.
   void leave_out(const std::string& name, const std::vector<std::string>& inputs = {});

   enum class Says { every_path, nothing };
   /// On stdout. Throws std::runtime_error, and writes nothing, where what was printed has not arrived.
   void commit(Says says = Says::every_path);

  private:
   std::filesystem::path temporary(const std::string& name) const;
   bool holds_earlier_result() const;

   std::filesystem::path path_;
   std::string option_;
   MadeFolders made_;
   std::vector<std::string> names_;
   std::vector<std::string> always_;  ///< of these, what all runs write
   std::vector<std::unique_ptr<PartialFile>> partial_;
   std::vector<std::string> left_out_;
};

}  // namespace stereo::app
