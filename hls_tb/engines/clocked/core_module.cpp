// SPDX-License-Identifier: Apache-2.0
// The clocked core of one configuration as a module that programs load (core_modules.hpp), compiled as the hardware top
// is: -DSTEREO_FAMILY=block_matching -DSTEREO_CONFIGURATION=ambrosch2007
#include "engines/clocked/clocked_core.hpp"

#define STEREO_TEXT(words) #words
#define STEREO_NAME(name) STEREO_TEXT(name)
#define STEREO_HEADER(name) STEREO_TEXT(name / family.hpp)

#include STEREO_HEADER(STEREO_FAMILY)

using Core = stereo::STEREO_FAMILY::Core<stereo::STEREO_FAMILY::configurations::STEREO_CONFIGURATION>;

extern "C" const stereo::CoreModule stereo_core_module{STEREO_NAME(STEREO_FAMILY), STEREO_NAME(STEREO_CONFIGURATION),
                                                       stereo::core_shape<Core>(), &stereo::make_clocked_core<Core>};
