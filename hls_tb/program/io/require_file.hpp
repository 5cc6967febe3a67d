// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <system_error>

#include "program/errors.hpp"

namespace stereo::app {

/// Throws InputError where `path` is no plain file: a pipe could keep its reader waiting for ever. `name`: for the
/// user.
inline void require_file(const std::string& path, const std::string& name) {
   std::error_code why;
   const std::filesystem::file_status status = std::filesystem::status(path, why);
   if (status.type() == std::filesystem::file_type::none) throw InputError(name + ": " + why.message());
   if (!std::filesystem::exists(status)) throw InputError(name + ": there is no such file");
   if (std::filesystem::is_directory(status)) throw InputError(name + ": is a folder; give a file");
   if (!std::filesystem::is_regular_file(status)) throw InputError(name + ": is a pipe or a device; give a file");
}

}  // namespace stereo::app
