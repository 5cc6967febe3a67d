// SPDX-License-Identifier: Apache-2.0
// Test vectors as text files, for test benches in any language.
//
// stimulus.txt: a first line "stereo-hls stimulus 2 config=<name> pixels=<P> clocks=<N>", then N lines "F LL RR", one a
//   clock:
//   F   one hex digit: bit 0 valid, bit 1 start of frame, bit 2 reset
//   LL  left, RR right pixels: words of 2*P lower-case hex digits, as the ports take them; bits 8p+7 ... 8p are lane p,
//       so the last lane, the lowest of the P rows, comes first in the text
//   Pixels of more than 8 bits: the first line ends with pixel_bits=<bits>; lanes of so many bits, in as few digits as
//       hold the P of them
//   A core with run-time settings: the first line also says settings=<ports>, and each line ends with a word of 4
//       digits for each port of a setting, in their order
// expected.txt: a first line "stereo-hls expected 2 config=<name> pixels=<P> disparity_bits=<8, 16 or 24> outputs=<N>
//   latency=<clocks>", then N lines "clock x y frame WORD flags", one a valid output, decimal but for WORD:
//   y      the row of lane 0
//   WORD   the disparities, a word like those above, in lanes of disparity_bits
//   flags  bit 0 start of frame, bit 1 end of line, bit 2+p lane p holds a valid pixel
#pragma once

#include <iosfwd>

#include "engines/clocked/stimulus.hpp"

namespace stereo {

void write_stimulus(std::ostream& out, const Stimulus& stimulus);
void write_expected(std::ostream& out, const Expected& expected);

}  // namespace stereo
