// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <memory>
#include <stdexcept>
#include <typeinfo>

namespace stereo {

/// The memories of one core in native code, filled with zeros at first. A core that is made anew on the memories of
/// another one starts as the hardware does after a reset. See MemoryBank.
class HeapMemories {
  public:
   template <class Word, int Depth, int Number>
   Word (&words())[Depth] {
      struct Array {
         Word words[Depth] = {};
      };
      Memory& memory = memories_[Number];
      if (!memory.array) memory = {std::make_shared<Array>(), &typeid(Array)};
      if (*memory.type != typeid(Array)) throw std::logic_error("two memories of a core have the same number");
      return static_cast<Array*>(memory.array.get())->words;
   }

  private:
   struct Memory {
      std::shared_ptr<void> array;
      const std::type_info* type = nullptr;
   };
   std::map<int, Memory> memories_;
};

}  // namespace stereo
