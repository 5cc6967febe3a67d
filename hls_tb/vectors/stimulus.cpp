// SPDX-License-Identifier: Apache-2.0
#include "vectors/stimulus.hpp"

#include <stdexcept>

namespace stereo {
namespace {

std::string size_text(int width, int height) { return std::to_string(width) + "x" + std::to_string(height); }

void check(const std::string& name, const StereoConfig& config, const ImagePair& pair, const StimulusOptions& options,
           RowRange rows) {
   const auto require = [](bool condition, const std::string& sentence) {
      if (!condition) throw std::invalid_argument(sentence);
   };
   for (const GrayImage* image : {&pair.left, &pair.right})
      require(image->width == config.width_px && image->height == config.height_px,
              "an image is " + size_text(image->width, image->height) + " but configuration " + name + " takes " +
                  size_text(config.width_px, config.height_px));
   require(options.frames >= 1, "the number of frames must be at least 1");
   require(options.stall_percent >= 0 && options.stall_percent <= 95, "the stall percentage must be 0 ... 95");
   const std::string range = "the row range " + std::to_string(rows.first) + ":" + std::to_string(rows.end);
   require(rows.first >= 0 && rows.first < rows.end && rows.end <= config.height_px,
           range + " must lie within 0:" + std::to_string(config.height_px) + " and not be empty");
   require(rows.end - rows.first > config.radius_px(),
           range + " would give no output: send at least " + std::to_string(config.radius_px() + 1) + " rows");
}

}  // namespace

void StimulusWriter::pair(uint8_t left, uint8_t right, bool start_of_frame) {
   while (random_.percent(stall_percent_)) bubbles(1);
   clocks.push_back({.left = left, .right = right, .start_of_frame = start_of_frame, .valid = true});
}

void StimulusWriter::rows(const ImagePair& images, RowRange range, bool upside_down) {
   for (int y = range.first; y < range.end; ++y) {
      const int row = upside_down ? images.left.height - 1 - y : y;
      for (int x = 0; x < images.left.width; ++x)
         pair(images.left.at(x, row), images.right.at(x, row), x == 0 && y == range.first);
   }
}

void StimulusWriter::random_pairs(int count) {
   for (int i = 0; i < count; ++i) {
      const uint8_t left = random_.byte();
      pair(left, random_.byte(), false);
   }
}

void StimulusWriter::bubbles(int count) {
   for (int i = 0; i < count; ++i) {
      const uint32_t garbage = random_.bits();
      clocks.push_back({.left = uint8_t(garbage),
                        .right = uint8_t(garbage >> 8),
                        .start_of_frame = (garbage >> 16 & 1) != 0,
                        .valid = false});
   }
}

Stimulus make_stimulus(const std::string& config_name, const StereoConfig& config, int latency_clocks,
                       const ImagePair& pair, const StimulusOptions& options) {
   const RowRange rows = options.rows.value_or(RowRange{0, config.height_px});
   check(config_name, config, pair, options, rows);
   StimulusWriter writer(options.stall_percent, options.seed);
   for (int frame = 0; frame < options.frames; ++frame) writer.rows(pair, rows, frame % 2 == 1);
   if (rows.end - rows.first == config.height_px) writer.flush(config);
   writer.drain(latency_clocks);
   return {config_name, std::move(writer.clocks)};
}

CoreOutput OutputLocator::locate(uint64_t clock, const StereoOutput& output) {
   CoreOutput located{.clock = clock,
                      .x = last_.x + 1,
                      .y = last_.y,
                      .frame = last_.frame,
                      .disparity = output.disparity,
                      .start_of_frame = output.start_of_frame,
                      .end_of_line = output.end_of_line};
   if (output.start_of_frame) {
      located.x = located.y = 0;
      ++located.frame;
   } else if (last_.end_of_line) {
      located.x = 0;
      ++located.y;
   }
   last_ = located;
   return located;
}

std::vector<GrayImage> collect_frames(const std::vector<CoreOutput>& outputs, const StereoConfig& config) {
   const int width = config.output_width_px(), height = config.output_height_px();
   const std::size_t frame_size = std::size_t(width) * std::size_t(height);
   if (outputs.size() % frame_size != 0)
      throw std::runtime_error("the core gave " + std::to_string(outputs.size()) +
                               " outputs, which is no multiple of " + size_text(width, height));
   std::vector<GrayImage> frames;
   for (std::size_t i = 0; i < outputs.size(); ++i) {
      const CoreOutput& output = outputs[i];
      const std::size_t pixel = i % frame_size;
      const int x = int(pixel % std::size_t(width)), y = int(pixel / std::size_t(width));
      const bool in_place = output.x == x && output.y == y && output.frame == int(i / frame_size) &&
                            output.start_of_frame == (pixel == 0) && output.end_of_line == (x == width - 1);
      if (!in_place)
         throw std::runtime_error("output " + std::to_string(i) + " stands at x=" + std::to_string(output.x) +
                                  " y=" + std::to_string(output.y) + " of frame " + std::to_string(output.frame) +
                                  " but belongs at x=" + std::to_string(x) + " y=" + std::to_string(y) + " of frame " +
                                  std::to_string(i / frame_size));
      if (pixel == 0) frames.emplace_back(width, height);
      frames.back().at(x, y) = output.disparity;
   }
   return frames;
}

}  // namespace stereo
