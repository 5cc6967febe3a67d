// SPDX-License-Identifier: Apache-2.0
// What the program needs of this family beside its core.
#pragma once

#include "definition/block_matching/matching_input.hpp"
#include "definition/block_matching/reference_model.hpp"
#include "engines/fast/block_matching/fast_model.hpp"
