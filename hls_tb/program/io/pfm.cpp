// SPDX-License-Identifier: Apache-2.0
#include "program/io/pfm.hpp"

#include <bit>
#include <charconv>
#include <cstdint>
#include <stdexcept>
#include <string>

namespace stereo::app {
namespace {

constexpr std::size_t kLongestWord = 32;

[[noreturn]] void refuse(const std::string& sentence) { throw std::invalid_argument(sentence); }

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

/// Takes the header's next word and the one byte of white space behind it.
std::string_view take_word(std::string_view& rest) {
   while (!rest.empty() && is_space(rest.front())) rest.remove_prefix(1);
   std::size_t length = 0;
   while (length < rest.size() && length <= kLongestWord && !is_space(rest[length])) ++length;
   if (length == 0 || length > kLongestWord || length == rest.size()) refuse("its PFM header is truncated");
   const std::string_view word = rest.substr(0, length);
   rest.remove_prefix(length + 1);
   return word;
}

template <class Number>
Number number(std::string_view word, const char* what) {
   Number value{};
   const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
   if (error != std::errc() || end != word.data() + word.size())
      refuse(std::string("its PFM header has no number as the ") + what);
   return value;
}

int side(std::string_view word, const char* what) {
   const int value = number<int>(word, what);
   if (value < 1 || value > kLargestPfmSide)
      refuse("its PFM header says a " + std::string(what) + " of " + std::to_string(value) + " but it must be 1 ... " +
             std::to_string(kLargestPfmSide));
   return value;
}

float float_at(std::string_view bytes, std::size_t offset, bool little_endian) {
   uint32_t word = 0;
   for (std::size_t i = 0; i < 4; ++i)
      word |= uint32_t(uint8_t(bytes[offset + i])) << (8 * (little_endian ? i : 3 - i));
   return std::bit_cast<float>(word);
}

}  // namespace

DisparityImage parse_pfm(std::string_view bytes) {
   std::string_view rest = bytes;
   const std::string_view kind = take_word(rest);
   if (kind == "PF") refuse("it is a colour PFM; give one with disparities, which begins with Pf");
   if (kind != "Pf") refuse("it does not begin with Pf as a PFM does");
   const int width = side(take_word(rest), "width"), height = side(take_word(rest), "height");
   const auto scale = number<double>(take_word(rest), "scale");
   if (!std::isfinite(scale) || scale == 0) refuse("its PFM header has a scale that gives no byte order");
   const uint64_t wanted = 4 * uint64_t(width) * uint64_t(height);
   if (rest.size() != wanted)
      refuse("it holds " + std::to_string(rest.size()) + " bytes of pixels but its PFM header says " +
             std::to_string(wanted));
   DisparityImage image(width, height);
   std::size_t offset = 0;
   for (int y = height - 1; y >= 0; --y)
      for (int x = 0; x < width; ++x, offset += 4) image.at(x, y) = float_at(rest, offset, scale < 0);
   return image;
}

}  // namespace stereo::app
