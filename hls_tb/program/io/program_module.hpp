// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <dlfcn.h>

#include <filesystem>
#include <string>

#include "program/errors.hpp"

namespace stereo::app {

/// What a module beside the program exports. It stays loaded. Throws MissingPart where there is none.
template <class Exported>
const Exported& program_module(const std::string& name, const char* entry) {
   const auto path = std::filesystem::read_symlink("/proc/self/exe").parent_path() / name;
   void* const library = dlopen(path.c_str(), RTLD_LAZY | RTLD_LOCAL);
   const void* const exported = library != nullptr ? dlsym(library, entry) : nullptr;
   if (exported == nullptr)
      throw MissingPart(path.string() + " cannot be loaded; it belongs beside the program (" + dlerror() + ")");
   return *static_cast<const Exported*>(exported);
}

}  // namespace stereo::app
