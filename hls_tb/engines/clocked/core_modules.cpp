// SPDX-License-Identifier: Apache-2.0
#include "engines/clocked/core_modules.hpp"

#include <dlfcn.h>

#include <cstdlib>
#include <string_view>

namespace stereo {
namespace {

std::filesystem::path& given_folder() {
   static std::filesystem::path folder;
   return folder;
}

std::filesystem::path module_folder() {
   if (const char* const chosen = std::getenv("STEREO_CORES"); chosen != nullptr) return chosen;
   if (!given_folder().empty()) return given_folder();
   return std::filesystem::read_symlink("/proc/self/exe").parent_path() / "cores";
}

}  // namespace

void set_core_folder(const std::filesystem::path& folder) { given_folder() = folder; }

const CoreModule& load_core_module(const std::filesystem::path& file) {
   void* const library = dlopen(std::filesystem::absolute(file).c_str(), RTLD_NOW | RTLD_LOCAL);
   const void* const entry = library != nullptr ? dlsym(library, "stereo_core_module") : nullptr;
   if (entry == nullptr) throw NoCoreModule(file.string() + " cannot be loaded: " + dlerror());
   const CoreModule& module = *static_cast<const CoreModule*>(entry);
   if (module.interface != std::string_view(STEREO_CORE_INTERFACE))
      throw NoCoreModule(file.string() + " is of another build than this program; make it again with cmake --build");
   return module;
}

const CoreModule& core_module(const std::string& name) {
   const std::filesystem::path file = module_folder() / (name + ".so");
   if (!std::filesystem::exists(file))
      throw NoCoreModule("the clocked core of " + name + " is not built: " + file.string() +
                         " is missing; make it with cmake --build BUILD_FOLDER --target core_" + name);
   const CoreModule& module = load_core_module(file);
   if (module.name != name) throw NoCoreModule(file.string() + " holds the core of " + module.name);
   return module;
}

}  // namespace stereo
