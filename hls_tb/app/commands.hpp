// SPDX-License-Identifier: Apache-2.0
// The program's commands. Each throws InputError or std::invalid_argument for what the user can mend.
#pragma once

#include <cstdint>
#include <string>

#include "app/images.hpp"
#include "models/scene.hpp"
#include "vectors/configuration_table.hpp"

namespace stereo::app {

/// Throws InputError with the list of the known ones.
const Configuration& require_configuration(const std::string& name);

enum class Engine { fast, clocked };

struct MatchArguments {
   std::string config, left, right, out;
   std::string truth, visible;  ///< the reference image's true disparities and what counts of them; both or none
   Engine engine = Engine::fast;
   Fit fit = Fit::none;
};
void match(const MatchArguments& arguments);

struct SceneArguments {
   std::string config, out;  ///< an empty config leaves the size to `options`
   SceneOptions options;
};
void scene(const SceneArguments& arguments);

struct VectorsArguments {
   std::string config, left, right, out;
   std::string rows;  ///< "A:B"; empty for all
   Fit fit = Fit::none;
   StimulusOptions options;
};
void vectors(const VectorsArguments& arguments);

/// Values of all registers under random pixel pairs, by which synthesis gives the registers of the VHDL their names.
struct TraceArguments {
   std::string config, out;
   int clocks = 1000;
};
void trace(const TraceArguments& arguments);

void list_configurations(bool as_json);

}  // namespace stereo::app
