// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

namespace stereo {

/// The memories of one core in native code: every core has its own, filled with zeros. See MemoryBank.
class HeapMemories {
  public:
   template <class Word, int Depth, int Number>
   Word (&words())[Depth] {
      struct Array {
         Word words[Depth] = {};
      };
      const auto array = std::make_shared<Array>();
      arrays_.push_back(array);
      return array->words;
   }

  private:
   std::vector<std::shared_ptr<void>> arrays_;
};

}  // namespace stereo
