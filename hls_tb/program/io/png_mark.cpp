// SPDX-License-Identifier: Apache-2.0
#include "program/io/png_mark.hpp"

#include <cstdint>
#include <fstream>

namespace stereo::app {
namespace {

using std::string_literals::operator""s;

constexpr std::size_t kHead = 33;  ///< bytes of the signature and of the chunk IHDR, which comes first
const std::string kTypeAndText = "tEXtSoftware\0stereo_hls video"s;

/// That of PNG's chunks, over type and content.
uint32_t crc(const std::string& bytes) {
   uint32_t value = ~uint32_t(0);
   for (const char byte : bytes) {
      value ^= uint8_t(byte);
      for (int bit = 0; bit < 8; ++bit) value = (value >> 1U) ^ (value % 2 == 1 ? 0xEDB88320U : 0U);
   }
   return ~value;
}

std::string big_endian(uint32_t value) {
   return {char(uint8_t(value >> 24U)), char(uint8_t(value >> 16U)), char(uint8_t(value >> 8U)), char(uint8_t(value))};
}

const std::string& chunk() {
   static const std::string bytes =
       big_endian(uint32_t(kTypeAndText.size() - 4)) + kTypeAndText + big_endian(crc(kTypeAndText));
   return bytes;
}

}  // namespace

std::string marked_png(const std::string& png) { return png.substr(0, kHead) + chunk() + png.substr(kHead); }

bool is_marked_png(const std::filesystem::path& path) {
   std::ifstream file(path, std::ios::binary);
   std::string found(kHead + chunk().size(), '\0');
   return file.read(found.data(), std::streamsize(found.size())) && found.substr(kHead) == chunk();
}

}  // namespace stereo::app
