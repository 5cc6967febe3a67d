// SPDX-License-Identifier: Apache-2.0
// What the program needs of this family beside its core.
#pragma once

#include "definition/phase_correlation/matching_input.hpp"
#include "definition/phase_correlation/reference_model.hpp"
#include "definition/phase_correlation/stress_pairs.hpp"
#include "engines/fast/phase_correlation/fast_model.hpp"
