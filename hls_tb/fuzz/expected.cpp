// SPDX-License-Identifier: Apache-2.0
#include <sstream>

#include "fuzz/targets.hpp"
#include "vectors/vector_files.hpp"

namespace stereo::fuzz {
namespace {

const std::string kName = "expected.txt";

Expected read(const std::string& text) {
   std::istringstream in(text);
   return read_expected(in, kName);
}

}  // namespace

bool expected(std::string_view bytes) {
   Expected found;
   try {
      found = read(std::string(bytes));
   } catch (const std::runtime_error& refusal) {
      check_refusal(refusal, kName + ":");
      return false;
   }
   std::ostringstream written;
   write_expected(written, found);
   const Expected again = read(written.str());
   promise(again.config == found.config && again.pixels_per_clock == found.pixels_per_clock &&
               again.disparity_bits == found.disparity_bits && again.latency_clocks == found.latency_clocks &&
               again.outputs == found.outputs,
           "what was written is read alike");
   return true;
}

}  // namespace stereo::fuzz
