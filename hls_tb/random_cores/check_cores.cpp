// SPDX-License-Identifier: Apache-2.0
// Compares cores of any family with the definition: whole frames, at exactly the gap and at the clocks that their
// schedules state, with bubbles, resets and broken frames.
//   check_cores SEED MODULE...
//   check_cores --interface     prints what a module must be compiled with: -DSTEREO_CORE_INTERFACE='"..."'
// A line for each module; the first difference ends its check. Exit codes: 0 all exact, 1 one differs, 2 wrong usage.
#include <charconv>
#include <cstring>
#include <iostream>
#include <string_view>

#include "random_cores/core_check.hpp"

int main(int argc, char** argv) {
   if (argc == 2 && std::string_view(argv[1]) == "--interface") {
      std::cout << STEREO_CORE_INTERFACE << '\n';
      return 0;
   }
   uint64_t seed = 0;
   const char* const end = argc > 1 ? argv[1] + std::strlen(argv[1]) : nullptr;
   if (argc < 3 || std::from_chars(argv[1], end, seed).ptr != end) {
      std::cerr << "usage: check_cores SEED MODULE...\n";
      return 2;
   }
   bool all_exact = true;
   for (int i = 2; i < argc; ++i) {
      const stereo::CoreModule& core = stereo::load_core_module(argv[i]);
      const stereo::CoreCheck check = stereo::check_core(core, seed);
      all_exact = all_exact && check.problem.empty();
      std::cout << core.name << ": "
                << (check.problem.empty() ? "exact, " + std::to_string(check.maps) + " maps" : check.problem)
                << std::endl;
   }
   return all_exact ? 0 : 1;
}
