// SPDX-License-Identifier: Apache-2.0
#include "engines/clocked/stimulus.hpp"

#include <algorithm>
#include <stdexcept>
#include <string_view>

#include "definition/pixel_range.hpp"

namespace stereo {
namespace {

/// Rows of the smallest crop that gives an output.
int least_rows(const CoreShape& core) {
   const int width = core.image.width_px;
   return (core.schedule.groups_to_first_output + width - 1) / width * core.image.pixels_per_clock;
}

template <class Pixel>
void check(const std::string& name, const CoreShape& core, const PairOf<Pixel>& pair, const StimulusOptions& options,
           RowRange rows) {
   const auto require = [](bool condition, const std::string& sentence) {
      if (!condition) throw std::invalid_argument(sentence);
   };
   const Image& config = core.image;
   for (const RasterImage<Pixel>* image : {&pair.left, &pair.right}) {
      require(image->width == config.width_px && image->height == config.height_px,
              "an image is " + size_text(*image) + " but configuration " + name + " takes " +
                  size_text(config.width_px, config.height_px));
      const std::string problem = beyond_range(*image, core.pixel_bits);
      require(problem.empty(), "an image for configuration " + name + " " + problem);
   }
   require(options.frames >= 1, "the number of frames must be at least 1");
   require(options.stall_percent >= 0 && options.stall_percent <= 95, "the stall percentage must be 0 ... 95");
   const std::string range = "the row range " + std::to_string(rows.first) + ":" + std::to_string(rows.end);
   require(rows.first >= 0 && rows.first < rows.end && rows.end <= config.height_px,
           range + " must lie within 0:" + std::to_string(config.height_px) + " and not be empty");
   const int group = config.pixels_per_clock, least = least_rows(core), count = rows.end - rows.first;
   require(count % group == 0, range + " has " + std::to_string(count) + " rows but must have a multiple of the " +
                                   std::to_string(group) + " pixels per clock");
   require(count >= least || count == config.height_px,
           range + " would give no output: send at least " + std::to_string(least) + " rows");
}

const Setting* held_setting(const SettingList& ports, std::string_view name) {
   for (const Setting& port : ports)
      if (port.held && port.name == name) return &port;
   return nullptr;
}

/// That the ports of a core can bring; its own where it has no such ports.
struct Sizes {
   std::vector<int> widths, heights;
};
Sizes widths_and_heights(const CoreShape& core) {
   const auto values = [&](const char* name, int own) {
      const Setting* const port = held_setting(core.settings, name);
      std::vector<int> all;
      if (port == nullptr) return std::vector{own};
      for (int value = port->least; value <= port->largest; value += port->step) all.push_back(value);
      return all;
   };
   return {values("image_width", core.image.width_px), values("image_height", core.image.height_px)};
}

Image with_size(Image image, int width, int height) {
   image.width_px = width;
   image.height_px = height;
   return image;
}

}  // namespace

bool has_size_ports(const SettingList& ports) { return held_setting(ports, "image_width") != nullptr; }

Image random_size(const CoreShape& core, Random& random) {
   Image size = core.image;
   const auto draw = [&](const char* name, int& value) {
      const Setting* const port = held_setting(core.settings, name);
      if (port == nullptr) return;
      const int most = (port->largest - port->least) / port->step;
      value = port->least + port->step * (random.percent(25) ? 0 : random.below(most + 1));
   };
   draw("image_width", size.width_px);
   draw("image_height", size.height_px);
   return size;
}

std::vector<Image> least_and_largest_sizes(const CoreShape& core) {
   const auto [widths, heights] = widths_and_heights(core);
   std::vector<Image> sizes;
   for (const int width : {widths.front(), widths.back()})
      for (const int height : {heights.front(), heights.back()}) sizes.push_back(with_size(core.image, width, height));
   return sizes;
}

std::vector<Image> each_width_and_height(const CoreShape& core, Random& random) {
   auto [widths, heights] = widths_and_heights(core);
   shuffle(widths, random);
   shuffle(heights, random);
   std::vector<Image> sizes;
   for (std::size_t i = 0; i < std::max(widths.size(), heights.size()); ++i)
      sizes.push_back(with_size(core.image, widths[i % widths.size()], heights[i % heights.size()]));
   return sizes;
}

CoreShape shape_at(CoreShape core, const Image& size) {
   core.output_width_px -= core.image.width_px - size.width_px;
   core.schedule.gap_groups = core.schedule.gap_groups / core.image.width_px * size.width_px;
   core.image = size;
   return core;
}

template <class Pixel>
PairOf<Pixel> cropped(const PairOf<Pixel>& pair, int width, int height) {
   PairOf<Pixel> part{RasterImage<Pixel>(width, height), RasterImage<Pixel>(width, height)};
   for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) {
         part.left.at(x, y) = pair.left.at(x, y);
         part.right.at(x, y) = pair.right.at(x, y);
      }
   return part;
}

template ImagePair cropped(const ImagePair&, int, int);
template DeepPair cropped(const DeepPair&, int, int);

void set_sizes(Stimulus& stimulus, const std::vector<SizeChange>& sizes) {
   if (!has_size_ports(stimulus.ports)) return;
   const auto set = [&](std::vector<uint32_t>& values, const SizeChange& size) {
      for (int i = 0; i < stimulus.ports.count; ++i) {
         const std::string_view name = stimulus.ports.setting[i].name;
         if (name == "image_width") values[std::size_t(i)] = uint32_t(size.width);
         if (name == "image_height") values[std::size_t(i)] = uint32_t(size.height);
      }
   };
   std::vector<SettingsChange> all;
   SizeChange now{0, held_setting(stimulus.ports, "image_width")->start,
                  held_setting(stimulus.ports, "image_height")->start};
   auto change = stimulus.settings.begin();
   const auto changes_before = [&](uint64_t clock) {
      for (; change != stimulus.settings.end() && change->clock < clock; ++change) {
         all.push_back(*change);
         set(all.back().values, now);
      }
   };
   for (const SizeChange& size : sizes) {
      changes_before(size.clock);
      now = size;
      if (change != stimulus.settings.end() && change->clock == size.clock) continue;
      std::vector<uint32_t> values;
      for (const Setting& port : stimulus.ports) values.push_back(uint32_t(port.start));
      all.push_back({size.clock, all.empty() ? values : all.back().values});
      set(all.back().values, now);
   }
   changes_before(stimulus.clocks.size());
   stimulus.settings = std::move(all);
}

void set_random_frames(Stimulus& stimulus, const SettingList& ports, uint64_t seed,
                       const std::vector<SizeChange>& sizes, Limits limits) {
   Random random(seed ^ 0x5e77);
   bool first = true;
   const auto next = [&] {
      std::vector<uint32_t> values = random_settings(ports, random, limits);
      if (first)
         for (int i = 0; i < ports.count; ++i) values[std::size_t(i)] = uint32_t(ports.setting[i].start);
      first = false;
      return values;
   };
   set_frames(stimulus, ports, random, next, sizes);
}

void StimulusWriter::record(const WideInput& in) {
   while (clocks.size() < next_record_ || random_.percent(stall_percent_)) bubbles(1);
   clocks.push_back(in);
   next_record_ = clocks.size() + std::size_t(clocks_per_group_ - 1);
}

template <class Pixel>
void StimulusWriter::rows(const PairOf<Pixel>& images, RowRange range, bool upside_down) {
   for (int group = range.first; group < range.end; group += pixels_per_clock_)
      for (int x = 0; x < images.left.width; ++x) {
         WideInput in{.start_of_frame = x == 0 && group == range.first, .valid = true};
         for (int p = 0; p < pixels_per_clock_; ++p) {
            const int y = upside_down ? images.left.height - 1 - (group + p) : group + p;
            in.left[p] = images.left.at(x, y);
            in.right[p] = images.right.at(x, y);
         }
         record(in);
      }
}

template void StimulusWriter::rows(const ImagePair&, RowRange, bool);
template void StimulusWriter::rows(const DeepPair&, RowRange, bool);

void StimulusWriter::random_records(int count) {
   for (int i = 0; i < count; ++i) {
      WideInput in = garbage();
      in.valid = true;
      record(in);
   }
}

void StimulusWriter::reset(int count) {
   for (int i = 0; i < count; ++i) {
      resets.push_back(clocks.size());
      WideInput in = garbage();
      in.valid = random_.percent(50);
      in.start_of_frame = random_.percent(50);
      clocks.push_back(in);
   }
}

void StimulusWriter::reset_to_size(int count, int width, int height) {
   sizes.push_back({clocks.size(), width, height});
   reset(count);
}

void StimulusWriter::bubbles(int count) {
   for (int i = 0; i < count; ++i) {
      WideInput in = garbage();
      in.start_of_frame = random_.percent(50);
      clocks.push_back(in);
   }
}

WideInput StimulusWriter::garbage() {
   const auto pixel = [this] { return uint16_t(random_.bits() & ((1u << pixel_bits_) - 1)); };
   WideInput in;
   for (int p = 0; p < pixels_per_clock_; ++p) {
      in.left[p] = pixel();
      in.right[p] = pixel();
   }
   return in;
}

namespace {

template <class Pixel>
Stimulus whole_frames(const std::string& config_name, const CoreShape& core, const PairOf<Pixel>& pair,
                      const StimulusOptions& options) {
   const RowRange rows = options.rows.value_or(RowRange{0, core.image.height_px});
   check(config_name, core, pair, options, rows);
   StimulusWriter writer(core, options.stall_percent, options.seed);
   const bool sized = has_size_ports(core.settings) && !options.rows;
   Random random(options.seed ^ 0x512e);
   PairOf<Pixel> shown = pair;
   RowRange shown_rows = rows;
   Schedule schedule = core.schedule;
   for (int frame = 0; frame < options.frames; ++frame) {
      if (sized && frame > 0 && frame % 2 == 0) {
         writer.flush(core.schedule);
         writer.drain(core.schedule);
         const Image size = random_size(core, random);
         writer.reset_to_size(1 + random.below(2), size.width_px, size.height_px);
         shown = cropped(pair, size.width_px, size.height_px);
         shown_rows = {0, size.height_px};
         schedule = shape_at(core, size).schedule;
      } else if (frame > 0) {
         writer.gap(schedule);
      }
      writer.rows(shown, shown_rows, frame % 2 == 1);
   }
   if (rows.end - rows.first == core.image.height_px) writer.flush(core.schedule);
   writer.drain(core.schedule);
   Stimulus stimulus{config_name, core.image.pixels_per_clock, std::move(writer.clocks), std::move(writer.resets)};
   stimulus.pixel_bits = core.pixel_bits;
   set_random_frames(stimulus, core.settings, options.seed, writer.sizes);
   return stimulus;
}

template <class Pixel>
Stimulus broken_frames(const std::string& config_name, const CoreShape& core, const PairOf<Pixel>& pair, int count,
                       int stall_percent, uint64_t seed) {
   RowRange all{0, core.image.height_px};
   check(config_name, core, pair, {.stall_percent = stall_percent}, all);
   const int width = core.image.width_px;
   Image size = core.image;
   PairOf<Pixel> shown = pair;
   Random random(seed ^ 0x5eed);  // what happens; the writer's is for bubbles and garbage
   StimulusWriter writer(core, stall_percent, seed);
   const auto whole_frame = [&] { writer.rows(shown, all, random.percent(50)); };
   const auto part_of_a_frame = [&] {
      const int frame = size.width_px * size.row_groups();
      StimulusWriter whole(core.image.pixels_per_clock, 0, random.bits());
      whole.rows(shown, all, random.percent(50));
      const int near_the_end = frame - random.below(std::min(frame, 2 * width));
      const int records = random.percent(60) ? near_the_end : 1 + random.below(frame);
      for (int i = 0; i < records; ++i) writer.record(whole.clocks[std::size_t(i)]);
   };
   writer.random_records(1 + random.below(2 * width));
   for (int i = 0; i < count; ++i) switch (random.below(4)) {
         case 0:
            part_of_a_frame();
            break;
         case 1:
            part_of_a_frame();
            if (has_size_ports(core.settings)) {
               size = random_size(core, random);
               shown = cropped(pair, size.width_px, size.height_px);
               all = {0, size.height_px};
               writer.reset_to_size(1 + random.below(3), size.width_px, size.height_px);
            } else {
               writer.reset(1 + random.below(3));
            }
            // At times more than a frame of them: a counter that is not at rest behind the reset comes round.
            writer.random_records(
                random.below(random.percent(20) ? size.width_px * (size.row_groups() + 8) : 2 * width));
            // What comes out of a broken frame may hang on what the memories held: not of the time before the reset.
            whole_frame();
            break;
         case 2:
            whole_frame();
            writer.gap(shape_at(core, size).schedule);
            break;
         default:
            whole_frame();
            writer.random_records(core.schedule.flush_groups + random.below(3 * width));
      }
   whole_frame();
   writer.flush(core.schedule);
   writer.drain(core.schedule);
   Stimulus stimulus{config_name, core.image.pixels_per_clock, std::move(writer.clocks), std::move(writer.resets)};
   stimulus.pixel_bits = core.pixel_bits;
   set_random_frames(stimulus, core.settings, seed, writer.sizes);
   return stimulus;
}

}  // namespace

Stimulus make_stimulus(const std::string& config_name, const CoreShape& core, const ImagePair& pair,
                       const StimulusOptions& options) {
   return whole_frames(config_name, core, pair, options);
}
Stimulus make_broken_stimulus(const std::string& config_name, const CoreShape& core, const ImagePair& pair, int count,
                              int stall_percent, uint64_t seed) {
   return broken_frames(config_name, core, pair, count, stall_percent, seed);
}

Stimulus make_stimulus(const std::string& config_name, const CoreShape& core, const DeepPair& pair,
                       const StimulusOptions& options) {
   return whole_frames(config_name, core, pair, options);
}
Stimulus make_broken_stimulus(const std::string& config_name, const CoreShape& core, const DeepPair& pair, int count,
                              int stall_percent, uint64_t seed) {
   return broken_frames(config_name, core, pair, count, stall_percent, seed);
}

}  // namespace stereo
