// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

namespace stereo::app {

/// A PNG file with a text chunk that says which command has written it.
std::string marked_png(const std::string& png);
/// Whether a file is there and has this chunk.
bool is_marked_png(const std::filesystem::path& path);

}  // namespace stereo::app
