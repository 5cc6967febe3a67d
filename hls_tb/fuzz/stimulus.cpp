// SPDX-License-Identifier: Apache-2.0
#include <sstream>

#include "fuzz/targets.hpp"
#include "vectors/vector_files.hpp"

namespace stereo::fuzz {
namespace {

const std::string kName = "stimulus.txt";

Stimulus read(const std::string& text) {
   std::istringstream in(text);
   return read_stimulus(in, kName);
}

std::string text_of(const Stimulus& stimulus) {
   std::ostringstream out;
   write_stimulus(out, stimulus);
   return out.str();
}

}  // namespace

bool stimulus(std::string_view bytes) {
   Stimulus found;
   try {
      found = read(std::string(bytes));
   } catch (const std::runtime_error& refusal) {
      check_refusal(refusal, kName + ":");
      return false;
   }
   const std::string written = text_of(found);
   promise(text_of(read(written)) == written, "what was written is read alike");
   return true;
}

}  // namespace stereo::fuzz
