// SPDX-License-Identifier: Apache-2.0
#include "engines/clocked/stress.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <vector>

#include "scene/stress_pairs.hpp"

namespace stereo {
namespace {

constexpr int kShortFrame = 4000;     // groups; of longer ones the first rows are sent
constexpr int kWantedClocks = 25000;  // of a core with short frames; the first round takes as many at most
constexpr int kRowsBeyondFirst = 2;   // groups of rows of a long frame beyond those that give the first output
constexpr int kShortLives = 1000;     // clocks of them all
constexpr int kLeastShortLives = 3;
constexpr int kLeastWildFrames = 6;                             // so that each event comes
constexpr int kFlushClocks = 8000, kBehindFlushClocks = 16000;  // for starts within the flush, and behind it
constexpr int kSizeClocks = 20000;                              // for frames of each width and height
constexpr int kResetClocks = 4000;                              // for resets within a map
constexpr int kLeastResets = 3;
constexpr int kLastShare = 3;              // of the clocks of all other streams, for frames of the last one
constexpr uint64_t kNextSeed = 1'000'003;  // from a stream to the one behind it: no seed that people try next

/// Gives each of some things once before any comes again, in another order each time.
template <class Thing, std::size_t Count>
class Deck {
  public:
   Deck(const std::array<Thing, Count>& things, Random& random) : things_(things), random_(random) {}

   Thing next() {
      if (next_ == Count) {
         next_ = 0;
         shuffle(things_, random_);
      }
      return things_[next_++];
   }

  private:
   std::array<Thing, Count> things_;
   Random& random_;
   std::size_t next_ = Count;
};

class Stress {
  public:
   Stress(const CoreShape& core, uint64_t seed)
       : core_(core), size_(core.image), random_(seed ^ 0x57e5), writer_(core, 0, seed) {}

   StimulusWriter make() {
      // What a reset leaves out shows only before the first start of frame.
      writer_.random_records(1 + random_.below(2 * size_.width_px));
      short_lives();
      tidy_round();
      wild_frames(is_short() ? kWantedClocks : 0);
      resets_within_a_map();
      frame(StressClass::patchwork);
      if (is_short()) writer_.flush(core_.schedule);
      writer_.drain(core_.schedule);
      return std::move(writer_);
   }

   /// What random streams meet too seldom, with frames of its classes in so many clocks or a few more.
   StimulusWriter make_last(std::size_t clocks, const std::vector<DeepPair>& own) {
      starts_behind_the_flush();
      each_size();
      for (const DeepPair& images : own) {
         send(images);
         writer_.gap(schedule());
      }
      last_frames(writer_.clocks.size() + clocks);
      writer_.drain(core_.schedule);
      return std::move(writer_);
   }

  private:
   int frame_records() const { return size_.width_px * (sent_rows().end / size_.pixels_per_clock); }
   int frame_groups() const { return size_.width_px * size_.row_groups(); }
   bool is_short() const { return frame_groups() <= kShortFrame; }
   Schedule schedule() const { return shape_at(core_, size_).schedule; }

   /// Whole where it is short.
   RowRange sent_rows() const {
      if (is_short()) return {0, size_.height_px};
      const int groups =
          (core_.schedule.groups_to_first_output + size_.width_px - 1) / size_.width_px + kRowsBeyondFirst;
      return {0, std::min(size_.height_px, groups * size_.pixels_per_clock)};
   }
   DeepPair pair(StressClass kind) {
      const RowRange rows = sent_rows();
      return stress_pair(kind, {size_.width_px, rows.end, core_.first_disparity, core_.disparities, core_.pixel_bits},
                         random_);
   }
   void send(const DeepPair& images) { writer_.rows(images, {0, images.left.height}); }
   void frame(StressClass kind) { send(pair(kind)); }
   /// The first records of one, most often up to its last rows, at times whole rows.
   void part_of_a_frame(StressClass kind) {
      const int all = frame_records(), width = size_.width_px;
      int records = 1 + random_.below(all);
      if (random_.percent(60)) records = all - random_.below(std::min(all, 2 * width));
      if (random_.percent(20)) records = std::max(width, records / width * width);
      first_records(kind, records);
   }
   void first_records(StressClass kind, int records) {
      StimulusWriter whole(core_.image.pixels_per_clock, 0, 0, core_.pixel_bits);
      const DeepPair images = pair(kind);
      whole.rows(images, {0, images.left.height});
      whole.clocks.resize(std::min(whole.clocks.size(), std::size_t(records)));
      for (const WideInput& record : whole.clocks) writer_.record(record);
   }

   /// Resets with a start of frame in the first clock behind them, each for the first rows of a frame: what a reset
   /// leaves out shows in its corner.
   void short_lives() {
      const std::size_t end = writer_.clocks.size() + kShortLives;
      for (int i = 0; i < kLeastShortLives || writer_.clocks.size() < end; ++i) {
         reset(any_size());
         const int records = schedule().groups_to_first_output + 1 + random_.below(2 * size_.width_px);
         first_records(i % 2 ? StressClass::edges : StressClass::noise, records);
         writer_.bubbles(core_.schedule.latency_clocks);
      }
      reset(core_.image);
   }

   /// Each class once, whole, as close as frames may be; of larger frames only some classes.
   void tidy_round() {
      for (tidy_ = 0; tidy_ < kStressClasses.size() && writer_.clocks.size() < kWantedClocks; ++tidy_) {
         if (tidy_ > 0) writer_.gap(schedule());
         frame(kStressClasses[tidy_]);
      }
      writer_.flush(core_.schedule);
      writer_.random_records(silence());
   }
   /// So many records without a start that whatever goes on behind the last frame shows.
   int silence() const { return (is_short() ? frame_groups() : 0) + 2 * size_.width_px; }

   /// The classes that have not come yet, then all again in any order, with all that may come between, up to so many
   /// clocks.
   void wild_frames(std::size_t clocks) {
      Deck kinds(kStressClasses, random_);
      Deck stalls(std::array{0, 0, 5, 30, 70}, random_);
      Deck whole(std::array{true, true, false, true}, random_);
      Deck behind_whole(std::array{Event::reset, Event::at_once, Event::flush, Event::gap, Event::false_start},
                        random_);
      Deck behind_part(std::array{Event::at_once, Event::at_once, Event::reset, Event::flush}, random_);
      broken_at_row_ends();
      for (int sent = 0; sent < kLeastWildFrames || tidy_ < kStressClasses.size() || writer_.clocks.size() < clocks;
           ++sent) {
         writer_.set_stall_percent(stalls.next());
         const StressClass kind = tidy_ < kStressClasses.size() ? kStressClasses[tidy_++] : kinds.next();
         const bool is_whole = was_reset_ || whole.next();
         if (is_whole) frame(kind);
         else part_of_a_frame(kind);
         was_reset_ = false;
         then(is_whole ? behind_whole.next() : behind_part.next());
      }
      writer_.set_stall_percent(0);
   }

   /// A frame that the next start breaks off one record before the end of a row, and one in its last row: counters that
   /// take either for the end of the frame go on wrongly.
   void broken_at_row_ends() {
      const int width = size_.width_px, rows = frame_records() / width;
      starts_in_the_flush();
      first_records(StressClass::patchwork, width * (1 + random_.below(std::max(1, rows - 1))) - 1);
      frame(StressClass::steps);
      first_records(StressClass::patchwork, width * rows - 1 - random_.below(width - 1));
   }

   /// From 1; some of them, at random, where all would take more than `clocks`. groups: of what is sent for each.
   std::vector<int> rows_of_the_flush(int groups, int clocks) {
      std::vector<int> rows(std::size_t((core_.schedule.flush_groups + size_.width_px - 1) / size_.width_px));
      std::iota(rows.begin(), rows.end(), 1);
      const std::size_t most = std::size_t(std::max(1, clocks / (groups * core_.schedule.clocks_per_group)));
      if (rows.size() <= most) return rows;
      shuffle(rows, random_);
      rows.resize(most);
      return rows;
   }

   /// A whole frame, then some of its flush rows as a frame that is broken off, then the next one: a start in the very
   /// clock in which a block ends the frame before.
   void starts_in_the_flush() {
      if (!is_short()) return;
      const int width = size_.width_px;
      for (const int row : rows_of_the_flush(frame_groups(), kFlushClocks)) {
         frame(StressClass::noise);
         first_records(StressClass::noise, std::min(row * width, frame_groups()));
      }
      frame(StressClass::noise);
   }

   /// A start in the very clock behind each row of the flush. What a counter makes of it shows behind the end of that
   /// frame.
   void starts_behind_the_flush() {
      if (!is_short()) return;
      const int width = size_.width_px;
      for (const int row : rows_of_the_flush(2 * frame_groups(), kBehindFlushClocks)) {
         frame(StressClass::noise);
         writer_.random_records(row * width);
         frame(StressClass::noise);
         writer_.flush(core_.schedule);
         writer_.random_records(2 * width);
      }
   }

   /// A frame of each width and of each height that the ports can bring. Behind those of the least and of the largest
   /// ones as many rows without a start as the largest image has: a counter that is not at rest comes round. Of large
   /// images only some.
   void each_size() {
      if (!has_size_ports(core_.settings)) return;
      const std::size_t end = writer_.clocks.size() + kSizeClocks;
      const auto take = [&](const std::vector<Image>& sizes, int rows_behind) {
         for (const Image& size : sizes) {
            if (writer_.clocks.size() >= end) return;
            reset(size);
            frame(StressClass::noise);
            writer_.flush(core_.schedule);
            writer_.random_records(rows_behind * size_.width_px);
         }
      };
      take(least_and_largest_sizes(core_), core_.image.row_groups() + 2);
      take(each_width_and_height(core_, random_), 2);
      reset(core_.image);
   }

   void last_frames(std::size_t end) {
      using enum StressClass;
      do {
         for (const StressClass kind : {contrary, tiles, contrary, rough, contrary, bands, contrary, enlarged}) {
            frame(kind);
            writer_.gap(schedule());
         }
      } while (writer_.clocks.size() < end);
      writer_.flush(core_.schedule);
   }

   /// A reset in the first rows of a map, then records without a start: what a block still holds would come out.
   void resets_within_a_map() {
      if (!is_short()) return;
      const std::size_t end = writer_.clocks.size() + kResetClocks;
      for (int i = 0; i < kLeastResets || writer_.clocks.size() < end; ++i) {
         reset(any_size());
         first_records(StressClass::noise, 1 + random_.below(schedule().groups_to_first_output + size_.width_px));
         if (has_size_ports(core_.settings)) reset(size_);
         else writer_.reset(1);
         writer_.random_records(schedule().groups_to_first_output + 2 * size_.width_px);
      }
      reset(core_.image);
   }

   enum class Event { reset, at_once, flush, gap, false_start };
   void then(Event event) {
      switch (event) {
         case Event::reset:
            reset(any_size());
            // At times none, so that the first record starts the frame; at times more than a frame of them: a counter
            // that is not at rest behind the reset comes round.
            if (random_.percent(70)) writer_.random_records(1 + random_.below(2 * size_.width_px));
            if (random_.percent(20) && is_short()) {
               writer_.set_stall_percent(0);
               writer_.random_records(frame_groups() + 6 * size_.width_px);
            }
            break;
         case Event::at_once:
            break;  // the next start of frame comes now: the frame before it is a broken one
         case Event::flush:
            writer_.flush(core_.schedule);
            writer_.random_records(size_.width_px + random_.below(size_.width_px));
            writer_.bubbles(random_.below(2 * core_.schedule.latency_clocks));
            break;
         case Event::gap:
            writer_.gap(schedule());
            break;
         case Event::false_start:
            false_start();
            break;
      }
   }
   /// A frame that takes the place of the flush of a whole one, and is broken off in it. What the core remembers of
   /// that shows behind the next whole frame, if none follows at once.
   void false_start() {
      writer_.gap(schedule());
      writer_.set_stall_percent(0);  // two frames more are long enough
      const int all = std::min(frame_records(), core_.schedule.flush_groups);
      first_records(StressClass::noise, 1 + random_.below(random_.percent(50) ? std::min(all, size_.width_px) : all));
      frame(StressClass::noise);
      then(Event::flush);
   }
   /// Of the frames behind a reset.
   Image any_size() {
      const bool is_fixed = !has_size_ports(core_.settings);
      return is_fixed || random_.percent(20) ? core_.image : random_size(core_, random_);
   }
   /// The next frame is whole: what comes out of a broken one may hang on what the memories held before the reset, and
   /// there the core in C++ and that in VHDL differ by the word that was under way.
   void reset(const Image& size) {
      was_reset_ = true;
      const int clocks = 1 + random_.below(3);
      if (!has_size_ports(core_.settings)) return writer_.reset(clocks);
      size_ = size;
      writer_.reset_to_size(clocks, size_.width_px, size_.height_px);
   }

   const CoreShape& core_;
   Image size_;  ///< of the frames that are sent
   Random random_;
   StimulusWriter writer_;
   bool was_reset_ = false;
   std::size_t tidy_ = 0;  ///< classes that have come once
};

Stimulus stream_of(const std::string& config_name, const CoreShape& core, uint64_t seed, StimulusWriter writer) {
   Stimulus stimulus{config_name, core.image.pixels_per_clock, std::move(writer.clocks), std::move(writer.resets)};
   stimulus.pixel_bits = core.pixel_bits;
   set_random_frames(stimulus, core.settings, seed, writer.sizes, Limits::exceeded);
   return stimulus;
}

}  // namespace

Stimulus make_stress_stimulus(const std::string& config_name, const CoreShape& core, uint64_t seed, std::size_t clocks,
                              const std::vector<DeepPair>& own) {
   const auto stream = [&] { return stream_of(config_name, core, seed, Stress(core, seed).make()); };
   Stimulus stimulus = stream();
   while (stimulus.clocks.size() < clocks) {
      seed += kNextSeed;
      append(stimulus, stream());
   }
   seed += kNextSeed;
   append(stimulus, stream_of(config_name, core, seed, Stress(core, seed).make_last(clocks / kLastShare, own)));
   return stimulus;
}

uint64_t append(Stimulus& stimulus, Stimulus next) {
   stimulus.resets.push_back(stimulus.clocks.size());
   stimulus.clocks.push_back({});
   const uint64_t begin = stimulus.clocks.size();
   if (stimulus.ports.count > 0) {
      std::vector<uint32_t> start;
      for (const Setting& port : stimulus.ports) start.push_back(uint32_t(port.start));
      stimulus.settings.push_back({begin - 1, std::move(start)});
   }
   stimulus.clocks.insert(stimulus.clocks.end(), next.clocks.begin(), next.clocks.end());
   for (const uint64_t clock : next.resets) stimulus.resets.push_back(begin + clock);
   for (SettingsChange& change : next.settings)
      stimulus.settings.push_back({begin + change.clock, std::move(change.values)});
   return begin;
}

}  // namespace stereo
