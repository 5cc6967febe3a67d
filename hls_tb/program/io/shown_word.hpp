// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cctype>
#include <string>

namespace stereo::app {

/// A word of a file as a part of a sentence for the user: in one line, and not longer than a line.
inline std::string shown_word(std::string word) {
   constexpr std::size_t kLongest = 40;
   if (word.size() > kLongest) word.resize(kLongest);
   for (char& c : word)
      if (std::isprint(static_cast<unsigned char>(c)) == 0) c = '?';
   return word;
}

}  // namespace stereo::app
