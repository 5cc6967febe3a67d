// SPDX-License-Identifier: Apache-2.0
#include "cosim/stage_files.hpp"

#include <iomanip>
#include <ostream>

namespace stereo {

namespace {

/// In whole hexadecimal digits.
int digits_of(int bits) { return (bits + 3) / 4; }

}  // namespace

void write_stage_stimulus(std::ostream& out, const Stage& stage, const std::vector<StageClock>& clocks) {
   out << "stereo-hls stimulus 2 config=" << stage.name << " pixels=1 clocks=" << clocks.size();
   if (stage.shape.pixel_bits != 8) out << " pixel_bits=" << stage.shape.pixel_bits;
   out << '\n' << std::hex << std::setfill('0');
   const int digits = digits_of(stage.shape.pixel_bits);
   for (const auto& [in, node, reset] : clocks)
      out << std::setw(2)
          << int(in.valid) + 2 * int(in.start_of_frame) + 4 * int(reset) + 8 * int(node.valid) + 16 * int(node.right)
          << ' ' << std::setw(digits) << in.left[0] << ' ' << std::setw(digits) << in.right[0] << ' ' << std::setw(4)
          << node.column << ' ' << std::setw(4) << node.row << ' ' << std::setw(4) << uint16_t(node.x) << ' '
          << std::setw(4) << uint16_t(node.y) << '\n';
   out << std::dec;
}

void write_stage_expected(std::ostream& out, const Stage& stage, const std::vector<StageOutput>& outputs) {
   out << "stereo-hls expected 2 config=" << stage.name << " pixels=1 disparity_bits=" << stage.shape.disparity_bits
       << " outputs=" << outputs.size() << " latency=" << stage.shape.schedule.latency_clocks << '\n'
       << std::setfill('0');
   const int bits = stage.shape.pixel_bits, digits = digits_of(2 * bits);
   for (const StageOutput& output : outputs)
      out << output.clock << ' ' << output.x << ' ' << output.y << ' ' << output.frame << ' ' << std::hex
          << std::setw(digits) << (output.right << bits | output.left) << std::dec << ' ' << int(output.start_of_frame)
          << '\n';
}

}  // namespace stereo
