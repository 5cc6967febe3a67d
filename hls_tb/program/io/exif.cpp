// SPDX-License-Identifier: Apache-2.0
#include "program/io/exif.hpp"

#include <cstddef>
#include <cstdint>

namespace stereo::app {
namespace {

using namespace std::string_view_literals;

constexpr int kUpright = 1;

/// Numbers of a file; 0 behind its end.
struct Numbers {
   std::string_view bytes;
   bool little_endian = false;

   uint32_t at(std::size_t offset, std::size_t count) const {
      uint32_t number = 0;
      if (offset > bytes.size() || bytes.size() - offset < count) return 0;
      for (std::size_t i = 0; i < count; ++i)
         number |= uint32_t(uint8_t(bytes[offset + i])) << (8 * (little_endian ? i : count - 1 - i));
      return number;
   }
};

std::string_view from(std::string_view bytes, std::size_t offset) {
   return offset < bytes.size() ? bytes.substr(offset) : ""sv;
}

/// Of a TIFF file or of EXIF data, which has its form: the tag 274 of the first directory.
int of_tiff(std::string_view bytes) {
   constexpr uint32_t kOrientation = 274;
   constexpr std::size_t kEntry = 12;
   if (!bytes.starts_with("II*\0"sv) && !bytes.starts_with("MM\0*"sv)) return kUpright;
   const Numbers numbers{bytes, bytes[0] == 'I'};
   const std::size_t directory = numbers.at(4, 4), entries = numbers.at(directory, 2);
   for (std::size_t i = 0; i < entries; ++i) {
      const std::size_t entry = directory + 2 + kEntry * i;
      if (entry + kEntry > bytes.size()) break;
      if (numbers.at(entry, 2) != kOrientation) continue;
      const uint32_t value = numbers.at(entry + 8, 2);
      return value >= 1 && value <= 8 ? int(value) : kUpright;
   }
   return kUpright;
}

/// EXIF data, with or without the mark that JPEG has before it.
int of_exif(std::string_view bytes) {
   constexpr auto kMark = "Exif\0\0"sv;
   return of_tiff(bytes.starts_with(kMark) ? bytes.substr(kMark.size()) : bytes);
}

int of_jpeg(std::string_view bytes) {
   const Numbers numbers{bytes};
   for (std::size_t marker = 2; numbers.at(marker, 1) == 0xff;) {
      const uint32_t kind = numbers.at(marker + 1, 1), length = numbers.at(marker + 2, 2);
      if (kind == 0xff) {  // padding
         ++marker;
         continue;
      }
      if (kind == 0xda || length < 2) break;  // the pixels, or damage
      const std::string_view content = from(bytes, marker + 4).substr(0, length - 2);
      if (kind == 0xe1 && content.starts_with("Exif\0\0"sv)) return of_exif(content);
      marker += 2 + length;
   }
   return kUpright;
}

/// Chunks of a length, a name and content, or in WebP of a name, a length and content. PNG has four more bytes behind.
int of_chunks(std::string_view bytes, std::size_t first, std::string_view name, bool is_png) {
   const Numbers numbers{bytes, !is_png};
   for (std::size_t chunk = first; chunk + 8 <= bytes.size();) {
      const std::size_t length = numbers.at(chunk + (is_png ? 0 : 4), 4);
      if (from(bytes, chunk + (is_png ? 4 : 0)).starts_with(name))
         return of_exif(from(bytes, chunk + 8).substr(0, length));
      chunk += 8 + length + (is_png ? 4 : length % 2);
   }
   return kUpright;
}

}  // namespace

int exif_orientation(std::string_view file) {
   if (file.starts_with("\xff\xd8"sv)) return of_jpeg(file);
   if (file.starts_with("\x89PNG\r\n\x1a\n"sv)) return of_chunks(file, 8, "eXIf", true);
   if (file.starts_with("RIFF"sv) && from(file, 8).starts_with("WEBP"sv)) return of_chunks(file, 12, "EXIF", false);
   return of_tiff(file);
}

}  // namespace stereo::app
