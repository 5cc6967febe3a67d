// SPDX-License-Identifier: Apache-2.0
// Runs the clocked core of own_96 on a pair, one call a clock, and writes the disparity map as PGM.
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

#include "engines/clocked/heap_memories.hpp"
#include "rows/block_matching.hpp"

namespace {

constexpr const auto& kConfig = stereo::block_matching::configurations::own_96;
using Core = stereo::block_matching::Core<stereo::block_matching::configurations::own_96>;
constexpr int kWidth = kConfig.width_px, kHeight = kConfig.height_px;

std::vector<unsigned char> read_pgm(const std::string& path) {
   std::ifstream file(path, std::ios::binary);
   std::string magic;
   int width = 0, height = 0, largest = 0;
   file >> magic >> width >> height >> largest;
   if (magic != "P5" || width != kWidth || height != kHeight || largest != 255)
      throw std::runtime_error(path + ": must be a PGM of 8 bits, " + std::to_string(kWidth) + "x" +
                               std::to_string(kHeight));
   file.get();  // the line feed behind the header
   std::vector<unsigned char> pixels(std::size_t(kWidth) * kHeight);
   if (!file.read(reinterpret_cast<char*>(pixels.data()), std::streamsize(pixels.size())))
      throw std::runtime_error(path + ": is truncated");
   return pixels;
}

std::vector<unsigned char> match(const std::vector<unsigned char>& left, const std::vector<unsigned char>& right) {
   stereo::HeapMemories memories;
   Core core(memories);
   std::vector<unsigned char> map;
   const auto clock = [&](const stereo::CoreInput<kConfig>& in) {
      const stereo::StereoOutput out = core.output();
      if (out.valid) map.push_back(static_cast<unsigned char>(out.disparity[0]));
      core.clock(in);
   };
   for (std::size_t i = 0; i < left.size(); ++i)
      clock({.left = {left[i]}, .right = {right[i]}, .start_of_frame = i == 0, .valid = true});
   for (int i = 0; i < Core::kSchedule.flush_groups; ++i) clock({.valid = true});
   for (int i = 0; i <= Core::kSchedule.latency_clocks; ++i) clock({});
   return map;
}

}  // namespace

int main(int argc, char** argv) try {
   if (argc != 4) {
      std::cerr << "usage: own_core LEFT.pgm RIGHT.pgm MAP.pgm\n";
      return 2;
   }
   const std::vector<unsigned char> map = match(read_pgm(argv[1]), read_pgm(argv[2]));
   constexpr int kColumns = kConfig.output_width_px();
   if (map.size() != std::size_t(kColumns) * kHeight)
      throw std::runtime_error("the core gave another number of pixels");
   std::ofstream file(argv[3], std::ios::binary);
   file << "P5 " << kColumns << ' ' << kHeight << " 255\n";
   file.write(reinterpret_cast<const char*>(map.data()), std::streamsize(map.size()));
   if (!file.flush()) throw std::runtime_error(std::string(argv[3]) + ": cannot be written");
   return 0;
} catch (const std::exception& error) {
   std::cerr << "own_core: " << error.what() << '\n';
   return 2;
}
