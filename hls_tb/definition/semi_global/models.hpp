// SPDX-License-Identifier: Apache-2.0
// What the program needs of this family beside its core.
#pragma once

#include "definition/semi_global/matching_input.hpp"
#include "definition/semi_global/reference_model.hpp"
#include "engines/fast/semi_global/fast_model.hpp"
