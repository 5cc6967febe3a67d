// SPDX-License-Identifier: Apache-2.0
#include "random_cores/core_check.hpp"

#include <algorithm>
#include <stdexcept>

#include "engines/clocked/run_core.hpp"
#include "engines/families.hpp"
#include "scene/stress_pairs.hpp"

namespace stereo {
namespace {

/// Ends a check.
struct Difference : std::runtime_error {
   using std::runtime_error::runtime_error;
};

/// Sets the options of an algorithm that it has; those of the images and the structure are none of it.
class Setter : public OptionSink {
  public:
   explicit Setter(std::shared_ptr<const Algorithm> start)
       : algorithm(std::move(start)), known_(algorithm->options()) {}

   void number(const char* name, int value) override { word(name, std::to_string(value).c_str()); }
   void word(const char* name, const char* value) override {
      const auto is_it = [name](const OptionValue& option) { return option.name == name; };
      if (std::any_of(known_.begin(), known_.end(), is_it)) algorithm = algorithm->with(name, value);
   }

   std::shared_ptr<const Algorithm> algorithm;

  private:
   std::vector<OptionValue> known_;
};

/// The algorithm with the options that the module has.
std::shared_ptr<const Algorithm> algorithm_of(const CoreModule& core) {
   for (const Family& family : families()) {
      if (family.name != core.family) continue;
      Setter setter(family.defaults);
      core.options(setter);
      return setter.algorithm;
   }
   throw std::runtime_error("there is no family " + std::string(core.family));
}

class Checker {
  public:
   Checker(const CoreModule& core, uint64_t seed)
       : core_(core),
         image_(core.shape.image),
         schedule_(core.shape.schedule),
         random_(seed),
         algorithm_(algorithm_of(core)) {}

   int maps() const { return maps_; }

   /// Frames one behind the other at exactly the gap, or at the gap that a flush leaves.
   void frames_in_a_row(int frames, int stall_percent, bool flushed) {
      StimulusWriter stream = writer(stall_percent);
      std::vector<DeepPair> sent;
      for (int i = 0; i < frames; ++i) {
         if (i > 0 && flushed) stream.random_records(std::max(schedule_.flush_groups, schedule_.gap_groups));
         else if (i > 0) stream.gap(schedule_);
         sent.push_back(random_pair());
         send(stream, sent.back());
      }
      stream.flush(schedule_);
      HeapMemories memories;
      const auto outputs = run(stream, memories);
      compare(sent, outputs,
              std::to_string(frames) + (flushed ? " flushed" : "") + " frames in a row" + stalls(stall_percent));
      if (!flushed) compare_clocks(stream.clocks, outputs);
   }

   /// A frame of which only some records come, then a whole one.
   void frame_after_a_broken_one() {
      StimulusWriter stream = writer(20);
      if (random_.percent(50)) {
         send(stream, random_pair());
         stream.gap(schedule_);
      }
      const int sent = 1 + random_.below(image_.width_px * image_.row_groups() + schedule_.flush_groups);
      send_part(stream, sent);
      const DeepPair last = random_pair();
      send(stream, last);
      stream.flush(schedule_);
      HeapMemories memories;
      std::vector<CoreOutput> of_last;
      for (const CoreOutput& output : run(stream, memories)) {
         if (output.start_of_frame) of_last.clear();
         of_last.push_back(output);
         of_last.back().frame = 0;
      }
      compare({last}, of_last, "a frame behind " + std::to_string(sent) + " records of another");
   }

   /// Frames of a smaller size behind a reset, where the core takes the size from ports, and then of one more.
   void frames_of_other_sizes() {
      HeapMemories memories;
      for (int i = 0; i < 2; ++i) {
         const Image size = random_size(core_.shape, random_);
         StimulusWriter stream = writer(i == 0 ? 0 : 30);
         stream.reset_to_size(1 + random_.below(2), size.width_px, size.height_px);
         std::vector<DeepPair> sent;
         for (int frame = 0; frame < 3; ++frame) {
            if (frame > 0) stream.gap(shape_at(core_.shape, size).schedule);
            sent.push_back(random_pair(size));
            send(stream, sent.back());
         }
         stream.flush(schedule_);
         stream.drain(schedule_);
         // Broken off anywhere: the next size finds what that has left in the memories.
         compare(sent, run(stream, memories), "3 frames of " + text(size), shape_at(core_.shape, size));
         StimulusWriter broken = writer(0);
         broken.reset_to_size(1, size.width_px, size.height_px);
         send_part(broken, 1 + random_.below(size.width_px * size.row_groups()), size);
         run(broken, memories);
      }
   }

   /// A reset keeps the memories as they were.
   void frame_after_a_reset() {
      HeapMemories memories;
      StimulusWriter before = writer(20), after = writer(20);
      const int sent = 1 + random_.below(image_.width_px * image_.row_groups() + schedule_.flush_groups);
      send_part(before, sent);
      run(before, memories);
      const DeepPair pair = random_pair();
      send(after, pair);
      after.flush(schedule_);
      compare({pair}, run(after, memories), "a frame behind a reset behind " + std::to_string(sent) + " records");
   }

   /// Records without a start of frame bring nothing out.
   void silence() {
      StimulusWriter stream = writer(20);
      stream.random_records(3 * image_.width_px * image_.row_groups());
      HeapMemories memories;
      if (const auto outputs = run(stream, memories); !outputs.empty())
         throw Difference(std::to_string(outputs.size()) + " outputs before the first start of frame");
   }

  private:
   static std::string stalls(int percent) { return percent == 0 ? "" : ", " + std::to_string(percent) + " % bubbles"; }

   StimulusWriter writer(int stall_percent) { return StimulusWriter(core_.shape, stall_percent, random_.bits()); }
   static std::string text(const Image& size) {
      return std::to_string(size.width_px) + "x" + std::to_string(size.height_px);
   }
   void send(StimulusWriter& to, const DeepPair& pair) const { to.rows(pair, {0, pair.left.height}); }
   /// The first records of a frame, and records without start behind them.
   void send_part(StimulusWriter& to, int records) { send_part(to, records, image_); }
   void send_part(StimulusWriter& to, int records, const Image& size) {
      StimulusWriter whole(image_.pixels_per_clock, 0, random_.bits(), core_.shape.pixel_bits);
      send(whole, random_pair(size));
      const int of_frame = std::min(records, int(whole.clocks.size()));
      for (int i = 0; i < of_frame; ++i) to.record(whole.clocks[std::size_t(i)]);
      to.random_records(records - of_frame);
   }
   /// Each frame with settings of its own, where the core takes any.
   std::vector<CoreOutput> run(StimulusWriter& stream, HeapMemories& memories) {
      stream.drain(schedule_);
      Stimulus stimulus{core_.name, image_.pixels_per_clock, stream.clocks, stream.resets};
      chosen_.clear();
      const auto next = [&] {
         chosen_.push_back(random_settings(core_.shape.settings, random_));
         return chosen_.back();
      };
      set_frames(stimulus, core_.shape.settings, random_, next, stream.sizes);
      return run_core(core_, stimulus, memories);
   }

   /// With the settings of a frame of the last run, counted from the last one.
   std::shared_ptr<const Algorithm> algorithm_of_frame(std::size_t from_last) const {
      std::shared_ptr<const Algorithm> algorithm = algorithm_;
      const SettingList& ports = core_.shape.settings;
      for (int i = 0; i < ports.count; ++i)
         if (ports.setting[i].largest > 0 && !ports.setting[i].held)
            algorithm = algorithm->with(ports.setting[i].name,
                                        std::to_string(chosen_.at(chosen_.size() - 1 - from_last)[std::size_t(i)]));
      return algorithm;
   }

   /// Of each class as often.
   DeepPair random_pair() { return random_pair(image_); }
   DeepPair random_pair(const Image& size) {
      const StressClass kind = kAllStressClasses[std::size_t(random_.below(int(kAllStressClasses.size())))];
      const CoreShape& shape = core_.shape;
      return stress_pair(
          kind, {size.width_px, size.height_px, shape.first_disparity, shape.disparities, shape.pixel_bits}, random_);
   }

   void compare(const std::vector<DeepPair>& sent, const std::vector<CoreOutput>& outputs, const std::string& what) {
      compare(sent, outputs, what, core_.shape);
   }
   void compare(const std::vector<DeepPair>& sent, const std::vector<CoreOutput>& outputs, const std::string& what,
                const CoreShape& shape) {
      std::vector<DisparityMap> got;
      try {
         got = collect_frames(outputs, shape);
      } catch (const std::runtime_error& problem) {
         throw Difference(what + ": " + problem.what());
      }
      if (got.size() != sent.size())
         throw Difference(what + ": " + std::to_string(got.size()) + " maps instead of " + std::to_string(sent.size()));
      for (std::size_t i = 0; i < sent.size(); ++i) {
         const DisparityMap expected = reference_map(*algorithm_of_frame(sent.size() - 1 - i), sent[i]);
         for (int y = 0; y < expected.height; ++y)
            for (int x = 0; x < expected.width; ++x)
               if (pixel(expected, x, y) != pixel(got[i], x, y))
                  throw Difference(what + ": frame " + std::to_string(i) + " x=" + std::to_string(x) +
                                   " y=" + std::to_string(y) + " expected " + pixel(expected, x, y) + " got " +
                                   pixel(got[i], x, y));
         ++maps_;
      }
   }
   /// Families of 8 bits only have no other images.
   DisparityMap reference_map(const Algorithm& algorithm, const DeepPair& pair) const {
      if (core_.shape.pixel_bits > 8) return algorithm.match_reference(pair.left, pair.right);
      return algorithm.match_reference(narrowed(pair.left), narrowed(pair.right));
   }
   static GrayImage narrowed(const DeepImage& image) {
      GrayImage narrow(image.width, image.height);
      std::transform(image.pixels.begin(), image.pixels.end(), narrow.pixels.begin(),
                     [](uint16_t pixel) { return uint8_t(pixel); });
      return narrow;
   }
   static std::string pixel(const DisparityMap& map, int x, int y) {
      const std::size_t place = std::size_t(y) * std::size_t(map.width) + std::size_t(x);
      std::string text = std::to_string(map.at(x, y));
      if (!map.valid_at(x, y)) text += map.has_value_at(x, y) ? " (filled)" : " (invalid)";
      if (!map.confidence.empty()) text += " of confidence " + std::to_string(map.confidence[place]);
      return text;
   }

   /// Every output comes latency_clocks after the record that it waits for.
   void compare_clocks(const std::vector<WideInput>& clocks, const std::vector<CoreOutput>& outputs) const {
      std::vector<uint64_t> clock_of_record;
      for (uint64_t clock = 0; clock < clocks.size(); ++clock)
         if (clocks[clock].valid) clock_of_record.push_back(clock);
      const int frame_records = image_.width_px * image_.row_groups() + schedule_.gap_groups;
      for (const CoreOutput& output : outputs) {
         const int record = output.frame * frame_records + schedule_.groups_to_first_output - 1 +
                            output.y / image_.pixels_per_clock * image_.width_px + output.x;
         const uint64_t wanted = clock_of_record.at(std::size_t(record)) + uint64_t(schedule_.latency_clocks);
         if (output.clock != wanted)
            throw Difference("frame " + std::to_string(output.frame) + " x=" + std::to_string(output.x) +
                             " y=" + std::to_string(output.y) + " came at clock " + std::to_string(output.clock) +
                             " instead of " + std::to_string(wanted));
      }
   }

   const CoreModule& core_;
   const Image& image_;
   const Schedule& schedule_;
   Random random_;
   std::shared_ptr<const Algorithm> algorithm_;
   std::vector<std::vector<uint32_t>> chosen_;  ///< settings of each frame of the last run
   int maps_ = 0;
};

}  // namespace

CoreCheck check_core(const CoreModule& core, uint64_t seed) {
   Checker checker(core, seed);
   try {
      checker.silence();
      for (const int frames : {2, 3})
         for (const int stall_percent : {0, 40}) checker.frames_in_a_row(frames, stall_percent, false);
      checker.frames_in_a_row(2, 20, true);
      if (has_size_ports(core.shape.settings)) checker.frames_of_other_sizes();
      for (int i = 0; i < 4; ++i) {
         checker.frame_after_a_broken_one();
         checker.frame_after_a_reset();
      }
   } catch (const Difference& difference) {
      return {checker.maps(), difference.what()};
   }
   return {checker.maps(), ""};
}

}  // namespace stereo
