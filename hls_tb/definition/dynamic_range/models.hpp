// SPDX-License-Identifier: Apache-2.0
// What the program needs of this family beside its core.
#pragma once

#include "definition/dynamic_range/matching_input.hpp"
#include "definition/dynamic_range/reference_model.hpp"
#include "definition/dynamic_range/stress_pairs.hpp"
#include "engines/fast/dynamic_range/fast_model.hpp"
