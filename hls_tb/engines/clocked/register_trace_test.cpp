// SPDX-License-Identifier: Apache-2.0
#include "engines/clocked/register_trace.hpp"

#include <gtest/gtest.h>

#include "engines/clocked/core_modules.hpp"

namespace stereo::test {
namespace {

class Digest {
  public:
   void add(uint64_t value) { state_ = mix_bits(state_ ^ value); }
   uint64_t value() const { return state_; }

  private:
   uint64_t state_ = 0;
};

uint64_t digest_of(const Stimulus& stimulus) {
   Digest digest;
   for (const WideInput& in : stimulus.clocks) {
      for (int p = 0; p < stimulus.pixels_per_clock; ++p) {
         digest.add(in.left[p]);
         digest.add(in.right[p]);
      }
      digest.add(in.start_of_frame);
      digest.add(in.valid);
   }
   for (const SettingsChange& change : stimulus.settings) {
      digest.add(change.clock);
      for (const uint32_t value : change.values) digest.add(value);
   }
   return digest.value();
}

/// The names of registers in the committed VHDL come from traces: where their stimulus changes, synthesize.py would
/// make other VHDL from the same C++. After such a change, make the VHDL of all cores again, and write the new digest
/// here.
TEST(TraceStimulus, IsThatOfTheCommittedVhdl) {
   const std::pair<const char*, uint64_t> cores[] = {
       {"tiny", 2027002894958442328}, {"tiny_settings", 668153544956499572}, {"tiny_size_all", 1315451751215524149}};
   for (const auto& [name, digest] : cores)
      EXPECT_EQ(digest_of(make_trace_stimulus(name, core_module(name).shape, 4000)), digest) << name;
}

}  // namespace
}  // namespace stereo::test
