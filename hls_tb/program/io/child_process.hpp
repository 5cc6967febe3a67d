// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>

namespace stereo::app {

/// Does the work in a child process and returns what it returned; nothing when it threw, crashed or was not done in
/// time. For libraries that do not survive every input. Throws std::runtime_error when there is no process to be had.
std::optional<std::string> done_by_child(const std::function<std::string()>& work, std::chrono::milliseconds limit);

}  // namespace stereo::app
