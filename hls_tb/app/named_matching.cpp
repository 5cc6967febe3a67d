// SPDX-License-Identifier: Apache-2.0
#include "app/named_matching.hpp"

#include "app/errors.hpp"
#include "app/options_json.hpp"
#include "models/fast_model.hpp"
#include "vectors/matching_parameters.hpp"

namespace stereo::app {

const Configuration& require_configuration(const std::string& name) {
   const Configuration* const found = find_configuration(name);
   if (found != nullptr) return *found;
   std::string known;
   for (const Configuration& entry : configuration_table()) known += (known.empty() ? "" : ", ") + entry.name;
   throw InputError("--config " + name + ": there is no such configuration; known are: " + known);
}

MatchingParameters named_parameters(const std::string& config, const std::vector<std::string>& settings) {
   return with_options(matching_parameters(require_configuration(config).config), settings);
}

DisparityMap match_named(const std::string& config, const ImagePair& pair, const MatchingParameters& parameters) {
   try {
      return match_fast(pair.left, pair.right, parameters);
   } catch (const std::invalid_argument& problem) {
      throw InputError("--config " + config + ": " + problem.what());
   }
}

}  // namespace stereo::app
