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

OutputFolder::OutputFolder(const std::string& path, const std::string& option)
    : path_(path), option_(option), made_(path_) {
   std::error_code ignored;
   if (!fs::is_directory(path_, ignored))
      throw InputError(option_ + " " + path + ": the folder cannot be created" +
                       (made_.error() ? " (" + made_.error().message() + ")" : "") + "; give one that can be written");
}

fs::path OutputFolder::temporary(const std::string& name) const {
   return path_ / ("." + name + ".partial-" + std::to_string(getpid()));
}

void OutputFolder::add(const std::string& name, const std::string& content, Runs writers) {
   std::error_code ignored;
   if (fs::is_directory(path_ / name, ignored))
      throw InputError((path_ / name).string() + ": is a folder; give another " + option_);
   names_.push_back(name);
   if (writers == Runs::all) always_.push_back(name);
   partial_.push_back(std::make_unique<PartialFile>(temporary(name)));
   std::ofstream file(temporary(name), std::ios::binary);
   file << content;
   file.close();
   if (!file)
      throw InputError(option_ + " " + path_.string() + ": " + name +
                       " cannot be written there; check free space and permissions");
}

void OutputFolder::add_json(const std::string& name, const nlohmann::json& json) {
   // A path in it may hold bytes that are no UTF-8.
   add(name, json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
}

void OutputFolder::leave_out(const std::string& name, const std::vector<std::string>& inputs) {
   std::error_code ignored;
   const fs::path path = path_ / name;
   const bool is_input = std::any_of(inputs.begin(), inputs.end(),
                                     [&](const std::string& input) { return fs::equivalent(path, input, ignored); });
   if (!is_input && fs::is_regular_file(path, ignored)) left_out_.push_back(name);
}

/// Else a file of that name is the user's own.
bool OutputFolder::holds_earlier_result() const {
   return std::all_of(always_.begin(), always_.end(), [this](const std::string& name) {
      std::error_code ignored;
      return fs::exists(path_ / name, ignored);
   });
}

void OutputFolder::commit(Says says) {
   if (says == Says::every_path)
      for (const std::string& name : names_) std::cout << (path_ / name).string() << '\n';
   require_printed();
   if (holds_earlier_result())
      for (const std::string& name : left_out_) fs::remove(path_ / name);
   for (const std::string& name : names_) fs::rename(temporary(name), path_ / name);
   names_.clear();
   partial_.clear();
}

}  // namespace stereo::app
