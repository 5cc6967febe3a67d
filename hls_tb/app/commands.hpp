// SPDX-License-Identifier: Apache-2.0
// The commands without a header of their own.
#pragma once

#include <CLI/App.hpp>

namespace stereo::app {

/// The command `scene`: a stereo pair with ground truth.
void add_scene(CLI::App& app);
/// The command `vectors`: what goes into a core and what must come out, as text files.
void add_vectors(CLI::App& app);
/// The command `trace`: values of all registers under random pixel pairs, by which synthesis gives the registers of the
/// VHDL their names.
void add_trace(CLI::App& app);
/// The command `configurations`: what this build knows.
void add_configurations(CLI::App& app);

}  // namespace stereo::app
