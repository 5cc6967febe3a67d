// SPDX-License-Identifier: Apache-2.0
#include "engines/clocked/random_settings.hpp"

#include <algorithm>
#include <iterator>
#include <string_view>

namespace stereo {

std::vector<uint32_t> random_settings(const SettingList& ports, Random& random) {
   std::vector<uint32_t> values;
   // Small values are the likely ones; both ends must come.
   for (const Setting& port : ports) {
      if (port.held) {
         values.push_back(uint32_t(port.start));
         continue;
      }
      const int span = port.largest - port.least;
      const int most = random.percent(50) ? span : std::min(span, 1 + span / 8);
      const int above = random.percent(15) ? 0 : random.below(most + 1);
      // Of the last disparity the large ones: most frames shall search something.
      const bool from_top = std::string_view(port.name) == "last_disparity";
      values.push_back(uint32_t(from_top ? port.largest - above : port.least + above));
   }
   return values;
}

bool counts_as_the_limit(const Setting& port) {
   constexpr std::string_view kClamped[] = {"p1",       "p2",        "p2_least",      "above_p1",
                                            "above_p2", "drop_cost", "occlusion_cost"};
   return std::ranges::find(kClamped, std::string_view(port.name)) != std::end(kClamped) && port.largest > 0;
}

void go_beyond_limits(std::vector<uint32_t>& values, const SettingList& ports, Random& random) {
   for (int i = 0; i < ports.count; ++i) {
      const Setting& port = ports.setting[i];
      uint32_t& value = values[std::size_t(i)];
      if (!counts_as_the_limit(port) || random.percent(50)) continue;
      const int beyond = (1 << port.bits) - 1 - port.largest;
      if (int(value) == port.largest && beyond > 0) {
         // By little, or in the upper bits.
         value += uint32_t(1 + random.below(random.percent(50) ? std::min(beyond, port.largest + 1) : beyond));
      } else if (int(value) == port.least && port.least > 0) {
         value = uint32_t(random.below(port.least));
      }
   }
}

}  // namespace stereo
