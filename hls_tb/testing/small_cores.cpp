// SPDX-License-Identifier: Apache-2.0
#include "testing/small_cores.hpp"

void stereo::test::add_plain_cores(std::vector<SmallCore>& cores) {
   add_cores(cores, Both<FewSmallConfigs, MoreSmallConfigs>::Configs());
}

const std::vector<stereo::test::SmallCore>& stereo::test::small_cores() {
   static const std::vector<SmallCore> cores = [] {
      std::vector<SmallCore> all;
      add_plain_cores(all);
      add_option_cores(all);
      return all;
   }();
   return cores;
}
