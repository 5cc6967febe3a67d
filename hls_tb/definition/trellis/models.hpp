// SPDX-License-Identifier: Apache-2.0
// What the program needs of this family beside its core.
#pragma once

#include "definition/trellis/matching_input.hpp"
#include "definition/trellis/reference_model.hpp"
#include "engines/fast/trellis/fast_model.hpp"
