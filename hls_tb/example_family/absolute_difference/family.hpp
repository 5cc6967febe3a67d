// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "absolute_difference/configurations.hpp"
#include "absolute_difference/core.hpp"
