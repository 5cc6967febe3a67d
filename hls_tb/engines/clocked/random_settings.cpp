// SPDX-License-Identifier: Apache-2.0
#include "engines/clocked/random_settings.hpp"

#include <algorithm>
#include <bit>
#include <string_view>

namespace stereo {
namespace {

/// Distance of a value from the limit that most of them are near to. Small ones are the likely ones; both ends and
/// those beside them must come.
int distance(int span, Random& random) {
   const int way = random.below(100);
   if (way < 15) return 0;
   if (way < 25) return span;
   if (way < 35) return std::clamp(random.percent(50) ? 1 : span - 1, 0, span);
   return random.below((way < 65 ? span : std::min(span, 1 + span / 8)) + 1);
}

/// One that the core takes as a limit: below the least, up to the next power of two above the largest, or a value
/// within the limits with a bit above them, which must count, too.
uint32_t beyond(const Setting& port, Random& random) {
   const unsigned largest = unsigned(port.largest), bits = unsigned(std::bit_width(largest));
   if (port.least > 0 && random.percent(25)) return uint32_t(random.below(port.least));
   const unsigned next = 1U << bits, free_bits = unsigned(port.bits) - bits;
   if (free_bits == 0 || random.percent(50)) {
      if (largest + 1 == 1U << port.bits) return largest;
      const unsigned end = std::max(next, largest + 2);
      return uint32_t(largest + 1 + unsigned(random.percent(50) ? 0 : random.below(int(end - largest - 1))));
   }
   const uint32_t within = uint32_t(port.least + random.below(port.largest - port.least + 1));
   return within | 1U << (bits + unsigned(random.below(int(free_bits))));
}

}  // namespace

std::vector<uint32_t> random_settings(const SettingList& ports, Random& random, Limits limits) {
   std::vector<uint32_t> values;
   for (const Setting& port : ports) {
      const std::string_view name = port.name;
      if (port.held) {
         values.push_back(uint32_t(port.start));
      } else if (limits == Limits::exceeded && port.clamped && random.percent(30)) {
         values.push_back(beyond(port, random));
      } else {
         // Of the last disparity most are large: most frames shall search something.
         const int from = distance(port.largest - port.least, random);
         values.push_back(uint32_t(name == "last_disparity" ? port.largest - from : port.least + from));
      }
   }
   // In some frames the search is narrow: costs differ by more where there are few.
   for (std::size_t i = 0; i + 1 < values.size(); ++i) {
      const Setting& next = ports.setting[i + 1];
      if (std::string_view(ports.setting[i].name) == "first_disparity" && next.largest > 0 && random.percent(20))
         values[i + 1] = std::min(uint32_t(next.largest), values[i] + uint32_t(random.below(5)));
   }
   return values;
}

}  // namespace stereo
