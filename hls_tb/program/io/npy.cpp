// SPDX-License-Identifier: Apache-2.0
#include "program/io/npy.hpp"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cstdint>
#include <regex>
#include <stdexcept>
#include <string>

#include "program/io/pfm.hpp"
#include "program/io/shown_word.hpp"

namespace stereo::app {
namespace {

constexpr std::string_view kMagic = "\x93NUMPY";
constexpr std::size_t kLongestHeader = 4096;  ///< numpy's take some hundred bytes

[[noreturn]] void refuse(const std::string& sentence) { throw std::invalid_argument(sentence); }

uint64_t whole_at(std::string_view bytes, std::size_t offset, std::size_t count, bool little_endian) {
   uint64_t word = 0;
   for (std::size_t i = 0; i < count; ++i)
      word |= uint64_t(uint8_t(bytes[offset + i])) << (8 * (little_endian ? i : count - 1 - i));
   return word;
}

float half(uint16_t bits) {
   const int exponent = bits >> 10 & 31, fraction = bits & 1023;
   const float size = exponent == 31  ? (fraction == 0 ? std::numeric_limits<float>::infinity() : kNoDisparity)
                      : exponent == 0 ? std::ldexp(float(fraction), -24)
                                      : std::ldexp(float(fraction + 1024), exponent - 25);
   return (bits >> 15) != 0 ? -size : size;
}

float value_at(std::string_view bytes, std::size_t offset, std::size_t size, bool little_endian) {
   const uint64_t word = whole_at(bytes, offset, size, little_endian);
   if (size == 2) return half(uint16_t(word));
   return size == 4 ? std::bit_cast<float>(uint32_t(word)) : float(std::bit_cast<double>(word));
}

/// The header's text, taken from `rest`.
std::string take_header(std::string_view& rest) {
   constexpr std::size_t kVersion = 6;
   if (rest.size() < kMagic.size() + 4) refuse("its NumPy header is truncated");
   const int version = uint8_t(rest[kVersion]);
   if (version < 1 || version > 3) refuse("it is of another version of NumPy's format than 1, 2 and 3");
   const std::size_t digits = version == 1 ? 2 : 4, start = kMagic.size() + 2 + digits;
   if (rest.size() < start) refuse("its NumPy header is truncated");
   const uint64_t length = whole_at(rest, kMagic.size() + 2, digits, true);
   if (length > kLongestHeader || rest.size() - start < length) refuse("its NumPy header is truncated");
   const std::string header(rest.substr(start, length));
   rest.remove_prefix(start + length);
   return header;
}

std::string found(const std::string& header, const char* pattern) {
   std::smatch match;
   return std::regex_search(header, match, std::regex(pattern)) ? match[1].str() : "";
}

int side(const std::string& digits) {
   int value = 0;
   std::from_chars(digits.data(), digits.data() + digits.size(), value);
   if (value < 1 || value > kLargestPfmSide)
      refuse("it has an axis of " + digits + " but it must be 1 ... " + std::to_string(kLargestPfmSide));
   return value;
}

}  // namespace

bool is_npy(std::string_view bytes) { return bytes.starts_with(kMagic); }

DisparityImage parse_npy(std::string_view bytes) {
   if (!is_npy(bytes)) refuse("it does not begin as an array of numpy.save does");
   std::string_view rest = bytes;
   const std::string header = take_header(rest), type = found(header, "'descr': *'([^']*)'"),
                     order = found(header, "'fortran_order': *(True|False)"),
                     shape = found(header, "'shape': *\\(([0-9, ]*)\\)");
   std::smatch sides;
   if (type.empty() || order.empty() || !header.starts_with('{')) refuse("its NumPy header names no array");
   const bool is_float = type.size() == 3 && (type[0] == '<' || type[0] == '>') && type[1] == 'f' &&
                         (type[2] == '2' || type[2] == '4' || type[2] == '8');
   if (!is_float) refuse("it is an array of " + shown_word(type) + "; give one of floats, disparities in pixels");
   if (!std::regex_match(shape, sides, std::regex(" *([0-9]+) *, *([0-9]+) *(, *1 *)?,? *")))
      refuse("it is an array of shape (" + shape + "); give one of two axes, rows and columns");
   const int height = side(sides[1]), width = side(sides[2]);
   const std::size_t size = std::size_t(type[2] - '0');
   if (rest.size() != size * std::size_t(width) * std::size_t(height))
      refuse("it holds " + std::to_string(rest.size()) + " bytes of values, which is not its shape (" + shape + ")");
   DisparityImage image(width, height);
   std::size_t offset = 0;
   const bool by_columns = order == "True";
   for (int i = 0; i < (by_columns ? width : height); ++i)
      for (int j = 0; j < (by_columns ? height : width); ++j, offset += size)
         (by_columns ? image.at(i, j) : image.at(j, i)) = value_at(rest, offset, size, type[0] == '<');
   return image;
}

}  // namespace stereo::app
