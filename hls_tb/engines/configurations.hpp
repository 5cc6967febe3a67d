// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "engines/algorithm.hpp"
#include "engines/clocked/core_shape.hpp"

namespace stereo {

/// A named configuration of any family. Its clocked core is in a module of its own: engines/clocked/core_modules.hpp.
struct Configuration {
   std::string name;
   std::string use;  ///< what it is there for, as its row says
   std::string family;
   std::string source_folder;  ///< of the family's core, from the project's root
   CoreShape shape;
   std::shared_ptr<const Algorithm> algorithm;
   std::vector<OptionValue> options;  ///< all: of the images, the matching and the structure
   std::vector<OptionValue> changed;  ///< those of the matching and the structure that are not the family's defaults

   /// Such as "320x240, 100 disparities, window 3x3".
   std::string description() const;
};

/// The named configurations of all families, sorted by name.
const std::vector<Configuration>& configurations();

/// nullptr when there is none of that name.
const Configuration* find_configuration(const std::string& name);

/// "there is no such configuration; known are: ...", for those who did not find one.
std::string no_such_configuration();

/// The options of a configuration but those of its images, where they differ from the family's defaults.
template <class Config>
std::vector<OptionValue> changed_options(const Config& config) {
   const std::vector<OptionValue> defaults = option_values(Config());
   std::vector<OptionValue> changed = option_values(config);
   const std::vector<OptionValue> of_images = option_values<Image>(config);
   std::erase_if(changed, [&](const OptionValue& option) {
      return std::ranges::find(defaults, option) != defaults.end() ||
             std::ranges::find(of_images, option) != of_images.end();
   });
   return changed;
}

/// An entry of the table.
template <class Core>
Configuration configuration_entry(std::string name, std::string use, std::string family, std::string source_folder) {
   const typename Core::Matching& matching = Core::kConfig;
   return {std::move(name),
           std::move(use),
           std::move(family),
           std::move(source_folder),
           core_shape<Core>(),
           std::make_shared<AlgorithmOf<typename Core::Matching>>(matching),
           option_values(Core::kConfig),
           changed_options(Core::kConfig)};
}

}  // namespace stereo
