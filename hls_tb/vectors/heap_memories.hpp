// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <memory>

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
      std::shared_ptr<void>& array = arrays_[Number];
      if (!array) array = std::make_shared<Array>();
      return static_cast<Array*>(array.get())->words;
   }

  private:
   std::map<int, std::shared_ptr<void>> arrays_;
};

}  // namespace stereo
