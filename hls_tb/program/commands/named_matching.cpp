// SPDX-License-Identifier: Apache-2.0
#include "program/commands/named_matching.hpp"

#include "program/commands/options_json.hpp"
#include "program/errors.hpp"

namespace stereo::app {

const Configuration& require_configuration(const std::string& name) {
   const Configuration* const found = find_configuration(name);
   if (found != nullptr) return *found;
   throw InputError("--config " + name + ": " + no_such_configuration());
}

std::shared_ptr<const Algorithm> named_algorithm(const std::string& config, const std::vector<std::string>& settings) {
   return with_options(require_configuration(config).algorithm, settings);
}

DisparityMap match_named(const std::string& config, const ImagePair& pair, const Algorithm& algorithm, int threads) {
   try {
      return algorithm.match_fast(pair.left, pair.right, threads);
   } catch (const std::invalid_argument& problem) {
      throw InputError("--config " + config + ": " + problem.what());
   }
}

}  // namespace stereo::app
