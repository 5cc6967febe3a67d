// SPDX-License-Identifier: Apache-2.0
#include "engines/clocked/register_trace.hpp"

#include "engines/clocked/lane_word.hpp"

namespace stereo {

void trace_core(const CoreModule& module, const Stimulus& stimulus, std::ostream& out) {
   const int pixels = module.shape.image.pixels_per_clock;
   HeapMemories memories;
   const auto core = module.make(memories);
   const std::vector<RegisterView> registers = core->registers();
   out << "stereo-hls trace 1 config=" << stimulus.config << " clocks=" << stimulus.clocks.size() << '\n'
       << "in_left_pixel in_right_pixel in_start_of_frame in_valid "
          "out_disparity out_pixel_valid out_disparity_valid out_disparity_start_of_frame out_disparity_end_of_line";
   for (const RegisterView& shown : registers) out << ' ' << shown.name;
   out << '\n' << std::hex;
   for (const StereoInput& in : stimulus.clocks) {
      const StereoOutput output = core->output();
      out << lane_word<uint8_t>(in.left, pixels, 8) << ' ' << lane_word<uint8_t>(in.right, pixels, 8) << ' '
          << in.start_of_frame << ' ' << in.valid << ' '
          << lane_word<uint16_t>(output.disparity, pixels, module.shape.disparity_bits) << ' '
          << lane_word<bool>(output.pixel_valid, pixels, 1) << ' ' << output.valid << ' ' << output.start_of_frame
          << ' ' << output.end_of_line;
      for (const RegisterView& shown : registers) {
         const auto [bits, negative] = shown.value();
         out << (negative ? " -" : " ") << (negative ? ~bits + 1 : bits);
      }
      out << '\n';
      core->clock(in);
   }
}

}  // namespace stereo
