// SPDX-License-Identifier: Apache-2.0
#include "program/io/output_folder.hpp"

#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>

#include "program/commands/standard_output.hpp"
#include "program/errors.hpp"

namespace stereo::app {

namespace fs = std::filesystem;

namespace {

constexpr const char* kFiles = "files";      ///< of this run
constexpr const char* kKept = "kept_files";  ///< of earlier ones, where this one reads them

}  // namespace

bool is_one_of(const fs::path& path, const std::vector<std::string>& files) {
   return std::any_of(files.begin(), files.end(), [&](const std::string& file) {
      std::error_code ignored;
      return fs::equivalent(path, file, ignored);
   });
}

OutputFolder::OutputFolder(const std::string& path, std::vector<std::string> inputs, const std::string& option)
    : path_(path), inputs_(std::move(inputs)), option_(option), made_(path_) {
   std::error_code ignored;
   if (!fs::is_directory(path_, ignored))
      throw InputError(option_ + " " + path + ": the folder cannot be created" +
                       (made_.error() ? " (" + made_.error().message() + ")" : "") + "; give one that can be written");
}

fs::path OutputFolder::temporary(const std::string& name) const {
   return path_ / ("." + name + ".partial-" + std::to_string(getpid()));
}

void OutputFolder::add(const std::string& name, const std::string& content) {
   std::error_code ignored;
   const fs::path path = path_ / name;
   const fs::file_type type = fs::symlink_status(path, ignored).type();
   const char* const hindrance = type == fs::file_type::directory ? "is a folder"
                                 : is_one_of(path, inputs_)       ? "is an input"
                                 : type != fs::file_type::regular && type != fs::file_type::not_found
                                     ? "is no regular file"
                                     : nullptr;
   if (hindrance) throw InputError(path.string() + ": " + hindrance + "; give another " + option_);
   names_.push_back(name);
   partial_.push_back(std::make_unique<PartialFile>(temporary(name)));
   std::ofstream file(temporary(name), std::ios::binary);
   file << content;
   file.close();
   if (!file)
      throw InputError(option_ + " " + path_.string() + ": " + name +
                       " cannot be written there; check free space and permissions");
}

void OutputFolder::add_json(const std::string& name, nlohmann::json json) {
   // A path in it may hold bytes that are no UTF-8.
   add(name, json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
}

void OutputFolder::add_facts(const std::string& name, nlohmann::json json) {
   std::vector<std::string> kept;
   for (const std::string& file : files_of_earlier_runs(name)) {
      if (std::find(names_.begin(), names_.end(), file) != names_.end()) continue;
      if (is_one_of(path_ / file, inputs_)) kept.push_back(file);
      else remove(file);
   }
   json[kFiles] = names_;
   if (!kept.empty()) json[kKept] = kept;
   add_json(name, std::move(json));
}

void OutputFolder::remove(const std::string& name) { stale_.push_back(name); }

/// Those of them that are still there. Nothing of a list that somebody else has written leads out of the folder.
std::vector<std::string> OutputFolder::files_of_earlier_runs(const std::string& facts) const {
   std::ifstream file(path_ / facts);
   const auto json = nlohmann::json::parse(file, nullptr, false);
   std::vector<std::string> found;
   for (const char* const list : {kFiles, kKept}) {
      if (!json.is_object() || !json.contains(list) || !json[list].is_array()) continue;
      for (const auto& entry : json[list]) {
         if (!entry.is_string()) continue;
         const fs::path name = entry.get<std::string>();
         std::error_code ignored;
         const bool is_there = fs::symlink_status(path_ / name, ignored).type() == fs::file_type::regular;
         if (name == name.filename() && is_there) found.push_back(name.string());
      }
   }
   return found;
}

void OutputFolder::commit(Says says) {
   if (says == Says::every_path)
      for (const std::string& name : names_) std::cout << (path_ / name).string() << '\n';
   require_printed();
   for (const std::string& name : stale_) fs::remove(path_ / name);
   for (const std::string& name : names_) fs::rename(temporary(name), path_ / name);
   names_.clear();
   partial_.clear();
}

}  // namespace stereo::app
