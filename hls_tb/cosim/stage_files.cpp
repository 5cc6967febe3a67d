// SPDX-License-Identifier: Apache-2.0
#include "cosim/stage_files.hpp"

#include <iomanip>
#include <ostream>

namespace stereo {

void write_stage_stimulus(std::ostream& out, const Stage& stage, const std::vector<StageClock>& clocks) {
   out << "stereo-hls stimulus 2 config=" << stage.name << " pixels=1 clocks=" << clocks.size() << '\n'
       << std::hex << std::setfill('0');
   for (const auto& [in, node, reset] : clocks)
      out << std::setw(2)
          << int(in.valid) + 2 * int(in.start_of_frame) + 4 * int(reset) + 8 * int(node.valid) + 16 * int(node.right)
          << ' ' << std::setw(2) << int(in.left[0]) << ' ' << std::setw(2) << int(in.right[0]) << ' ' << std::setw(4)
          << node.column << ' ' << std::setw(4) << node.row << ' ' << std::setw(4) << uint16_t(node.x) << ' '
          << std::setw(4) << uint16_t(node.y) << '\n';
   out << std::dec;
}

void write_stage_expected(std::ostream& out, const Stage& stage, const std::vector<StageOutput>& outputs) {
   out << "stereo-hls expected 2 config=" << stage.name << " pixels=1 disparity_bits=" << stage.shape.disparity_bits
       << " outputs=" << outputs.size() << " latency=" << stage.shape.schedule.latency_clocks << '\n'
       << std::setfill('0');
   for (const StageOutput& output : outputs)
      out << output.clock << ' ' << output.x << ' ' << output.y << ' ' << output.frame << ' ' << std::hex
          << std::setw(4) << (output.right << 8 | output.left) << std::dec << ' ' << int(output.start_of_frame) << '\n';
}

}  // namespace stereo
