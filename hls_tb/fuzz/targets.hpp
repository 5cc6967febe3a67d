// SPDX-License-Identifier: Apache-2.0
// A fuzz target for each reader of files. A target hands any bytes to its reader and what was read to the code behind
// it, and tells whether the reader took the bytes. A refusal is the exception that the reader documents, with one
// sentence; every other exception leaves the target, and so does BrokenPromise.
#pragma once

#include <exception>
#include <stdexcept>
#include <string>
#include <string_view>

namespace stereo::fuzz {

bool calibration(std::string_view bytes);         ///< a file of any format, by the child process that reads it
bool camera_calibration(std::string_view bytes);  ///< of the formats that are not OpenCV's; one file or two
bool disparities(std::string_view bytes);         ///< ground truth or results: every kind of file
bool image(std::string_view bytes);               ///< an image of a pair
bool pfm(std::string_view bytes);

struct Target {
   const char* name;
   bool (*run)(std::string_view bytes);
};

/// The folder fuzz/corpus/ has one of each name.
inline constexpr Target kTargets[] = {{"calibration", calibration},
                                      {"camera_calibration", camera_calibration},
                                      {"disparities", disparities},
                                      {"image", image},
                                      {"pfm", pfm}};

struct BrokenPromise : std::logic_error {
   using std::logic_error::logic_error;
};

/// Throws BrokenPromise with the sentence.
inline void promise(bool kept, const char* sentence) {
   if (!kept) throw BrokenPromise(sentence);
}

/// A refusal is one sentence that begins as said.
inline void check_refusal(const std::exception& refusal, const std::string& start) {
   const std::string sentence = refusal.what();
   if (sentence.size() <= start.size() || !sentence.starts_with(start) || sentence.find('\n') != std::string::npos)
      throw BrokenPromise("this refusal is no sentence that begins with \"" + start + "\": \"" + sentence + "\"");
}

}  // namespace stereo::fuzz
