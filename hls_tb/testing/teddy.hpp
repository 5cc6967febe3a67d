// SPDX-License-Identifier: Apache-2.0
// The real stereo pair teddy, which not every machine has.
#pragma once

#include <cstdlib>
#include <filesystem>

namespace stereo::test {

/// The folder teddy in that of env STEREO_DATA; empty where it holds no pair.
inline std::filesystem::path teddy_folder() {
   const char* const data = std::getenv("STEREO_DATA");
   const std::filesystem::path folder =
       std::filesystem::path(data != nullptr ? data : STEREO_SOURCE_DIR "/../shared/data/stereo") / "teddy";
   return std::filesystem::exists(folder / "left.png") ? folder : std::filesystem::path();
}

inline constexpr const char* kNoTeddy =
    "SKIP: the stereo pair teddy is missing; set STEREO_DATA to the folder that holds teddy/left.png";

}  // namespace stereo::test
