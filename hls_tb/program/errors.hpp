// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>

namespace stereo::app {

/// Something the user can mend: exit code 2. The text is one sentence that names the file or option.
struct InputError : std::runtime_error {
   using std::runtime_error::runtime_error;
};

/// A part of the program is not where it should be: exit code 3.
struct MissingPart : std::runtime_error {
   using std::runtime_error::runtime_error;
};

}  // namespace stereo::app
