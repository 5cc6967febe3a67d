// SPDX-License-Identifier: Apache-2.0
// Prints random configurations of a family as rows of its table.
//   random_rows FAMILY SEED COUNT
#include <charconv>
#include <cstring>
#include <iostream>

#include "engines/families.hpp"

namespace {

template <class Number>
bool read(const char* text, Number& number) {
   const char* const end = text + std::strlen(text);
   const auto [rest, error] = std::from_chars(text, end, number);
   return error == std::errc() && rest == end;
}

}  // namespace

int main(int argc, char** argv) {
   uint64_t seed = 0;
   int count = 0;
   if (argc != 4 || !read(argv[2], seed) || !read(argv[3], count)) {
      std::cerr << "usage: random_rows FAMILY SEED COUNT\n";
      return 2;
   }
   for (const stereo::Family& family : stereo::families()) {
      if (family.name != std::string(argv[1])) continue;
      stereo::Random random(seed);
      for (int i = 0; i < count; ++i)
         std::cout << "STEREO_ROW(random_" << seed << '_' << i << ", random, Config(), " << family.random_row(random)
                   << ");\n";
      return 0;
   }
   std::cerr << "random_rows: there is no family " << argv[1] << '\n';
   return 2;
}
