// SPDX-License-Identifier: Apache-2.0
// Test vectors of the rectification, in the files of vector_files.hpp with more fields.
//
// stimulus.txt: lines "FF LL RR CCCC RRRR XXXX YYYY", all hexadecimal:
//   FF          bit 0 valid, bit 1 start of frame, bit 2 reset, bit 3 a node, bit 4 of the right camera
//   LL RR       the cameras' pixels; of more than 8 bits in three digits, and the first line ends with pixel_bits=
//   CCCC RRRR   column and row of the node
//   XXXX YYYY   its offsets in two's complement
// expected.txt: disparity_bits=, twice pixel_bits, is the width of WORD: the left camera's rectified pixel in its lower
//   half, the right camera's in the upper one; flags: bit 0 start of frame.
#pragma once

#include <iosfwd>

#include "engines/rectification/stage_stimulus.hpp"

namespace stereo {

void write_stage_stimulus(std::ostream& out, const Stage& stage, const std::vector<StageClock>& clocks);
void write_stage_expected(std::ostream& out, const Stage& stage, const std::vector<StageOutput>& outputs);

}  // namespace stereo
