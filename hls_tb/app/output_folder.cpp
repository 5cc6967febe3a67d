// SPDX-License-Identifier: Apache-2.0
#include "app/output_folder.hpp"

#include <unistd.h>

#include <fstream>
#include <iostream>

#include "app/errors.hpp"

namespace stereo::app {

namespace fs = std::filesystem;

OutputFolder::OutputFolder(const std::string& path, const std::string& option) : path_(path), option_(option) {
   std::error_code error;
   is_new_ = fs::create_directories(path_, error);
   std::error_code ignored;
   if (!fs::is_directory(path_, ignored))
      throw InputError(option_ + " " + path + ": the folder cannot be created" +
                       (error ? " (" + error.message() + ")" : "") + "; give one that can be written");
}

OutputFolder::~OutputFolder() {
   std::error_code ignored;
   for (const std::string& name : names_) fs::remove(temporary(name), ignored);
   if (is_new_ && fs::is_empty(path_, ignored)) fs::remove(path_, ignored);
}

fs::path OutputFolder::temporary(const std::string& name) const {
   return path_ / ("." + name + ".partial-" + std::to_string(getpid()));
}

void OutputFolder::add(const std::string& name, const std::string& content) {
   std::error_code ignored;
   if (fs::is_directory(path_ / name, ignored))
      throw InputError((path_ / name).string() + ": is a folder; give another " + option_);
   names_.push_back(name);
   std::ofstream file(temporary(name), std::ios::binary);
   file << content;
   file.close();
   if (!file)
      throw InputError(option_ + " " + path_.string() + ": " + name +
                       " cannot be written there; check space and rights");
}

void OutputFolder::commit(Says says) {
   for (const std::string& name : names_) {
      fs::rename(temporary(name), path_ / name);
      if (says == Says::every_path) std::cout << (path_ / name).string() << '\n';
   }
   names_.clear();
}

}  // namespace stereo::app
