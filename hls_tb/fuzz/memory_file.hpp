// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/mman.h>
#include <unistd.h>

#include <stdexcept>
#include <string>
#include <string_view>

namespace stereo::fuzz {

/// A file in memory, for readers that take a path.
class MemoryFile {
  public:
   explicit MemoryFile(std::string_view bytes) : descriptor_(memfd_create("fuzz", MFD_CLOEXEC)) {
      if (descriptor_ < 0 || write(descriptor_, bytes.data(), bytes.size()) != ssize_t(bytes.size()))
         throw std::runtime_error("a file in memory cannot be written");
   }
   ~MemoryFile() { close(descriptor_); }
   MemoryFile(const MemoryFile&) = delete;
   MemoryFile& operator=(const MemoryFile&) = delete;

   std::string path() const { return "/proc/self/fd/" + std::to_string(descriptor_); }

  private:
   int descriptor_;
};

}  // namespace stereo::fuzz
