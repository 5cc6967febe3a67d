// SPDX-License-Identifier: Apache-2.0
#include "engines/clocked/core_outputs.hpp"

#include <stdexcept>
#include <string>

#include "definition/gray_image.hpp"

namespace stereo {

CoreOutput OutputLocator::locate(uint64_t clock, const PostOutput& output) {
   CoreOutput located{.clock = clock,
                      .x = last_.x + 1,
                      .y = last_.y,
                      .frame = last_.frame,
                      .disparity = std::to_array(output.disparity),
                      .pixel_valid = std::to_array(output.pixel_valid),
                      .confidence = std::to_array(output.confidence),
                      .filled = std::to_array(output.filled),
                      .start_of_frame = output.start_of_frame,
                      .end_of_line = output.end_of_line};
   if (output.start_of_frame) {
      located.x = located.y = 0;
      ++located.frame;
   } else if (last_.end_of_line) {
      located.x = 0;
      located.y += pixels_per_clock_;
   }
   last_ = located;
   return located;
}

std::vector<DisparityMap> collect_frames(std::span<const CoreOutput> outputs, const CoreShape& core) {
   const Image& image = core.image;
   const int width = core.output_width_px, height = image.height_px;
   const std::size_t columns = std::size_t(width), frame_size = columns * std::size_t(image.row_groups());
   if (outputs.size() % frame_size != 0)
      throw std::runtime_error("the core gave " + std::to_string(outputs.size()) +
                               " outputs, which is no multiple of " + size_text(width, image.row_groups()));
   std::vector<DisparityMap> frames;
   for (std::size_t i = 0; i < outputs.size(); ++i) {
      const CoreOutput& output = outputs[i];
      const std::size_t place = i % frame_size;
      const int x = int(place % columns), y = int(place / columns) * image.pixels_per_clock;
      const bool in_place = output.x == x && output.y == y && output.frame == int(i / frame_size) &&
                            output.start_of_frame == (place == 0) && output.end_of_line == (x == width - 1);
      if (!in_place)
         throw std::runtime_error("output " + std::to_string(i) + " stands at x=" + std::to_string(output.x) +
                                  " y=" + std::to_string(output.y) + " of frame " + std::to_string(output.frame) +
                                  " but belongs at x=" + std::to_string(x) + " y=" + std::to_string(y) + " of frame " +
                                  std::to_string(i / frame_size));
      if (place == 0) {
         frames.emplace_back(width, height, uint16_t(0), core.steps_per_pixel > 1);
         if (core.has_confidence) frames.back().confidence.resize(frames.back().valid.size());
         if (core.has_filled) frames.back().filled.resize(frames.back().valid.size());
      }
      for (int p = 0; p < image.pixels_per_clock; ++p) {
         frames.back().at(x, y + p) = output.disparity[std::size_t(p)];
         frames.back().valid_at(x, y + p) = output.pixel_valid[std::size_t(p)] ? 1 : 0;
         if (core.has_confidence) frames.back().confidence_at(x, y + p) = output.confidence[std::size_t(p)];
         if (core.has_filled) frames.back().filled_at(x, y + p) = output.filled[std::size_t(p)] ? 1 : 0;
      }
   }
   return frames;
}

}  // namespace stereo
