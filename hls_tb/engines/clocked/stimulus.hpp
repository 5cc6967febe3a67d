// SPDX-License-Identifier: Apache-2.0
// What goes into a core, clock by clock, and what must come out.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "definition/disparity_map.hpp"
#include "definition/gray_image.hpp"
#include "engines/clocked/core_outputs.hpp"
#include "engines/clocked/core_shape.hpp"
#include "engines/clocked/random_settings.hpp"
#include "scene/random.hpp"
#include "support/ports.hpp"

namespace stereo {

/// What the ports of the settings show from a clock on.
struct SettingsChange {
   uint64_t clock;
   std::vector<uint32_t> values;  ///< in the order of CoreShape::settings
};

/// The size of the images from a clock with reset on, of a core that takes it from ports.
struct SizeChange {
   uint64_t clock;
   int width, height;
};

/// The inputs of a core, one record a clock.
struct Stimulus {
   std::string config;    ///< the configuration's name
   int pixels_per_clock;  ///< lanes in use, 1, 2 or 4; lane p holds row p of a group of rows
   std::vector<WideInput> clocks;
   std::vector<uint64_t> resets = {};          ///< the clocks with reset, in ascending order
   SettingList ports = {};                     ///< of the settings; none where the core has no such ports
   std::vector<SettingsChange> settings = {};  ///< in ascending order; without any the ports show what the row says
   int pixel_bits = 8;                         ///< of a grey value
};

struct Expected {
   std::string config;
   int pixels_per_clock;
   int disparity_bits;  ///< of one lane, 8, 16 or 24 (LaneLayout)
   int latency_clocks;
   std::vector<CoreOutput> outputs;
   bool has_confidence = false, has_filled = false;
};

/// The lanes of an output's word.
template <class Output>
std::array<uint32_t, kMostPixels> output_lanes(const Output& output, const LaneLayout& layout) {
   std::array<uint32_t, kMostPixels> lanes{};
   for (std::size_t p = 0; p < lanes.size(); ++p)
      lanes[p] = layout.lane(output.disparity[p], output.confidence[p], output.filled[p]);
   return lanes;
}

/// Image rows first ... end-1.
struct RowRange {
   int first = 0;
   int end = 0;
};

struct StimulusOptions {
   /// Back to back; odd ones show the pair upside down, so that frames differ. Where the size comes from ports, the
   /// first two have the configuration's, and each two more a random one, behind a reset.
   int frames = 1;
   std::optional<RowRange> rows = std::nullopt;  ///< send only these rows of each frame, as if the first were the top
   int stall_percent = 0;                        ///< chance of a bubble before each clock, 0 ... 95
   uint64_t seed = 1;                            ///< of the bubbles, of their garbage and of the flush rows
};

/// Puts records and bubbles in a row. Bubbles and flush records carry garbage on the lanes in use, 0 on the others.
class StimulusWriter {
  public:
   /// Records a clock after one another, or `clocks_per_group` apart.
   StimulusWriter(int pixels_per_clock, int stall_percent, uint64_t seed, int pixel_bits = 8, int clocks_per_group = 1)
       : pixels_per_clock_(pixels_per_clock),
         stall_percent_(stall_percent),
         random_(seed),
         pixel_bits_(pixel_bits),
         clocks_per_group_(clocks_per_group) {}
   /// As close as the core takes them.
   StimulusWriter(const CoreShape& core, int stall_percent, uint64_t seed)
       : StimulusWriter(core.image.pixels_per_clock, stall_percent, seed, core.pixel_bits,
                        core.schedule.clocks_per_group) {}

   /// Of the records from now on.
   void set_stall_percent(int stall_percent) { stall_percent_ = stall_percent; }
   /// Bubbles that the core needs, random ones, then the record.
   void record(const WideInput& in);
   /// These rows of the images, a whole number of groups, as the top of a frame; upside down: row y is the y-th from
   /// below.
   template <class Pixel>
   void rows(const PairOf<Pixel>& images, RowRange range, bool upside_down = false);
   void random_records(int count);
   void bubbles(int count);
   /// The random records that bring out the last rows of a frame.
   void flush(const Schedule& schedule) { random_records(schedule.flush_groups); }
   /// What must stand between two frames.
   void gap(const Schedule& schedule) { random_records(schedule.gap_groups); }
   /// Enough bubbles to empty the pipeline.
   void drain(const Schedule& schedule) { bubbles(schedule.latency_clocks + 4); }
   /// Clocks with reset and garbage.
   void reset(int count);
   /// The same; from the first of them on the images have another size.
   void reset_to_size(int count, int width, int height);

   std::vector<WideInput> clocks;
   std::vector<uint64_t> resets;  ///< the clocks with reset
   std::vector<SizeChange> sizes;

  private:
   WideInput garbage();

   int pixels_per_clock_;
   int stall_percent_;
   Random random_;
   int pixel_bits_;
   int clocks_per_group_;
   std::size_t next_record_ = 0;  ///< the first clock that may have one
};

/// Whole frames are followed by a flush, parts of frames by bubbles only: they lack the rows that end a frame.
/// Throws std::invalid_argument with one sentence when the options or the images do not fit the configuration.
Stimulus make_stimulus(const std::string& config_name, const CoreShape& core, const ImagePair& pair,
                       const StimulusOptions& options = {});
Stimulus make_stimulus(const std::string& config_name, const CoreShape& core, const DeepPair& pair,
                       const StimulusOptions& options = {});

/// What a stream does that no camera should do: records without a start of frame, frames broken off anywhere, most
/// often in their last rows, starts as early as the next record, more records behind a frame than it needs, resets at
/// any clock. `count` such events, then a whole frame; frames show the pair and the pair upside down. Throws
/// std::invalid_argument with one sentence when the images do not fit the configuration.
Stimulus make_broken_stimulus(const std::string& config_name, const CoreShape& core, const ImagePair& pair, int count,
                              int stall_percent, uint64_t seed);
Stimulus make_broken_stimulus(const std::string& config_name, const CoreShape& core, const DeepPair& pair, int count,
                              int stall_percent, uint64_t seed);

/// Whether the size of the images comes from ports.
bool has_size_ports(const SettingList& ports);
/// A random size that the ports of a core can bring, its own where it has no such ports.
Image random_size(const CoreShape& core, Random& random);
/// The least and the largest width that the ports of a core can bring, each with the least and the largest height.
std::vector<Image> least_and_largest_sizes(const CoreShape& core);
/// Sizes that bring each width and each height at least once, in any order.
std::vector<Image> each_width_and_height(const CoreShape& core, Random& random);
/// What everybody must know of the core while it takes images of another size. The gap is of as many rows; the rest of
/// the schedule stays that of the largest images.
CoreShape shape_at(CoreShape core, const Image& size);
/// The left upper part of the images.
template <class Pixel>
PairOf<Pixel> cropped(const PairOf<Pixel>& pair, int width, int height);

/// Lets the ports of the size show these from their clocks on, and the configuration's size before.
void set_sizes(Stimulus& stimulus, const std::vector<SizeChange>& sizes);

/// Gives each frame of the stimulus settings of its own, in the clock of its start only: in all others the ports show
/// garbage. `next()`: those of the next frame; `sizes`: of the images. Nothing where the core has no such ports.
template <class Next>
void set_frames(Stimulus& stimulus, const SettingList& ports, Random& random, Next next,
                const std::vector<SizeChange>& sizes = {}) {
   stimulus.ports = ports;
   if (ports.count == 0) return;
   for (uint64_t clock = 0; clock < stimulus.clocks.size(); ++clock) {
      const WideInput& in = stimulus.clocks[clock];
      const bool starts = in.valid && in.start_of_frame;
      const bool started = clock > 0 && stimulus.clocks[clock - 1].valid && stimulus.clocks[clock - 1].start_of_frame;
      if (starts) {
         stimulus.settings.push_back({clock, next()});
      } else if (started || clock == 0 || random.percent(2)) {
         std::vector<uint32_t> garbage;
         for (const Setting& port : ports)
            garbage.push_back(uint32_t(random.bits() & ((uint64_t(1) << port.bits) - 1)));
         stimulus.settings.push_back({clock, std::move(garbage)});
      }
   }
   set_sizes(stimulus, sizes);
}

/// The first frame has the settings of the row, the others random ones; with Limits::exceeded some of them are beyond
/// the limits.
void set_random_frames(Stimulus& stimulus, const SettingList& ports, uint64_t seed,
                       const std::vector<SizeChange>& sizes, Limits limits = Limits::kept);

}  // namespace stereo
