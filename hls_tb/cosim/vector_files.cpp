// SPDX-License-Identifier: Apache-2.0
#include "cosim/vector_files.hpp"

#include <ostream>

#include "engines/clocked/lane_word.hpp"

namespace stereo {
namespace {

constexpr char kHexDigits[] = "0123456789abcdef";

/// The text of a word of P lanes.
template <class Lane>
std::string word_text(const Lane& lanes, int pixels, int lane_bits) {
   using Value = std::remove_cvref_t<decltype(lanes[0])>;
   const uint64_t word = lane_word<Value>(lanes, pixels, lane_bits);
   std::string text;
   for (int bit = (lane_bits * pixels + 3) / 4 * 4 - 4; bit >= 0; bit -= 4) text += kHexDigits[word >> bit & 15];
   return text;
}

std::string setting_text(uint32_t value) {
   std::string text;
   for (int bit = 12; bit >= 0; bit -= 4) text += kHexDigits[value >> bit & 15];
   return text;
}

}  // namespace

void write_stimulus(std::ostream& out, const Stimulus& stimulus) {
   const int pixels = stimulus.pixels_per_clock;
   out << "stereo-hls stimulus 2 config=" << stimulus.config << " pixels=" << pixels
       << " clocks=" << stimulus.clocks.size();
   if (stimulus.ports.count > 0) out << " settings=" << stimulus.ports.count;
   if (stimulus.pixel_bits != 8) out << " pixel_bits=" << stimulus.pixel_bits;
   out << '\n';
   std::string settings;
   for (const Setting& port : stimulus.ports) settings += ' ' + setting_text(uint32_t(port.start));
   auto change = stimulus.settings.begin();
   auto reset = stimulus.resets.begin();
   for (uint64_t clock = 0; clock < stimulus.clocks.size(); ++clock) {
      const WideInput& in = stimulus.clocks[clock];
      const bool resets = reset != stimulus.resets.end() && *reset == clock;
      if (resets) ++reset;
      out << int(in.valid) + 2 * int(in.start_of_frame) + 4 * int(resets) << ' '
          << word_text(in.left, pixels, stimulus.pixel_bits) << ' ' << word_text(in.right, pixels, stimulus.pixel_bits);
      if (change != stimulus.settings.end() && change->clock == clock) {
         settings.clear();
         for (const uint32_t value : change++->values) settings += ' ' + setting_text(value);
      }
      out << settings << '\n';
   }
}

void write_expected(std::ostream& out, const Expected& expected) {
   const int pixels = expected.pixels_per_clock;
   const LaneLayout layout{expected.disparity_bits, expected.has_confidence, expected.has_filled};
   out << "stereo-hls expected 2 config=" << expected.config << " pixels=" << pixels
       << " disparity_bits=" << expected.disparity_bits << " outputs=" << expected.outputs.size()
       << " latency=" << expected.latency_clocks << '\n';
   for (const CoreOutput& output : expected.outputs)
      out << output.clock << ' ' << output.x << ' ' << output.y << ' ' << output.frame << ' '
          << word_text(output_lanes(output, layout), pixels, expected.disparity_bits) << ' '
          << unsigned(output.start_of_frame) + 2 * unsigned(output.end_of_line) +
                 4 * lane_word<bool>(output.pixel_valid, pixels, 1)
          << '\n';
}

}  // namespace stereo
