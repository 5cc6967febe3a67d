// SPDX-License-Identifier: Apache-2.0
// What a user of the hardware top names: the core of this family and its named configurations.
#pragma once

#include "semi_global/configurations.hpp"
#include "semi_global/folded_core.hpp"
