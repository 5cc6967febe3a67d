// SPDX-License-Identifier: Apache-2.0
#include "engines/clocked/register_list.hpp"

namespace stereo {

void RegisterLister::add(const char* name, const Member& member) {
   std::size_t count = 1;
   for (const std::size_t extent : member.extents) count *= extent == 0 ? 1 : extent;
   add_elements(prefix_.empty() ? name : prefix_ + "_" + name, member, 0, 0, count);
}

void RegisterLister::add_block(const char* name, int number, void* block, List list) {
   const std::string outer = prefix_;
   prefix_ += name + (number < 0 ? std::string() : std::to_string(number));
   list(block, *this);
   prefix_ = outer;
}

/// The `count` elements from number `first` on, which are one element of the array's dimension number `dimension`.
void RegisterLister::add_elements(const std::string& name, const Member& member, int dimension, std::size_t first,
                                  std::size_t count) {
   if (const std::size_t extent = member.extents[dimension]; extent != 0) {
      for (std::size_t i = 0; i < extent; ++i)
         add_elements(name + "_" + std::to_string(i), member, dimension + 1, first + i * (count / extent), count / extent);
      return;
   }
   void* const element = static_cast<char*>(member.first) + first * member.bytes;
   if (member.list == nullptr) {
      list_.push_back({name, element, member.read});
      return;
   }
   const std::string outer = prefix_;
   prefix_ = name;
   member.list(element, *this);
   prefix_ = outer;
}

}  // namespace stereo
