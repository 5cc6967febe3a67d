// SPDX-License-Identifier: Apache-2.0
// The clocked core of one configuration as a module that programs load (core_modules.hpp), compiled as the hardware top
// is: -DSTEREO_FAMILY=block_matching -DSTEREO_CONFIGURATION=ambrosch2007, for rows beside the named ones also
// -DSTEREO_ROWS='"rows.hpp"'
#include "engines/clocked/clocked_core.hpp"

#define STEREO_TEXT(words) #words
#define STEREO_NAME(name) STEREO_TEXT(name)
// clang-format off
#define STEREO_HEADER(name) STEREO_TEXT(name/family.hpp)
// clang-format on

#include STEREO_HEADER(STEREO_FAMILY)

#ifdef STEREO_ROWS  // a header with more rows
namespace stereo::STEREO_FAMILY::configurations {
#include STEREO_ROWS
}  // namespace stereo::STEREO_FAMILY::configurations
#endif

using Core = stereo::STEREO_FAMILY::Core<stereo::STEREO_FAMILY::configurations::STEREO_CONFIGURATION>;

extern "C" const stereo::CoreModule stereo_core_module{
    STEREO_CORE_INTERFACE,       STEREO_NAME(STEREO_FAMILY),   STEREO_NAME(STEREO_CONFIGURATION),
    stereo::core_shape<Core>(), &stereo::list_options<Core>, &stereo::make_clocked_core<Core>};
