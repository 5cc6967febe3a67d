// SPDX-License-Identifier: Apache-2.0
// What a user of the hardware top names: the core of this family and its named configurations.
#pragma once

#include "block_matching/configurations.hpp"
#include "block_matching/folded_core.hpp"
