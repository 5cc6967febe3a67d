// SPDX-License-Identifier: Apache-2.0
#include "engines/clocked/register_trace.hpp"

#include <algorithm>
#include <string_view>

#include "engines/clocked/lane_word.hpp"

namespace stereo {
namespace {

class TextTrace final : public TraceSink {
  public:
   explicit TextTrace(std::ostream& out) : out_(out) {}

   void names(const std::vector<std::string>& names) override {
      const char* space = "";
      for (const std::string& name : names) {
         out_ << space << name;
         space = " ";
      }
      out_ << '\n' << std::hex;
   }
   void clock(std::span<const Value> values) override {
      const char* space = "";
      for (const auto [bits, negative] : values) {
         out_ << space << (negative ? "-" : "") << (negative ? ~bits + 1 : bits);
         space = " ";
      }
      out_ << '\n';
   }

  private:
   std::ostream& out_;
};

}  // namespace

void trace_core(const CoreModule& module, const Stimulus& stimulus, TraceSink& sink, uint64_t first) {
   const int pixels = module.shape.image.pixels_per_clock;
   const LaneLayout layout{module.shape.disparity_bits, module.shape.has_confidence, module.shape.has_filled};
   HeapMemories memories;
   auto core = module.make(memories);
   std::vector<RegisterView> registers = core->registers();
   std::vector<std::string> names{"in_left_pixel",
                                  "in_right_pixel",
                                  "in_start_of_frame",
                                  "in_valid",
                                  "out_disparity",
                                  "out_pixel_valid",
                                  "out_disparity_valid",
                                  "out_disparity_start_of_frame",
                                  "out_disparity_end_of_line"};
   for (const Setting& port : stimulus.ports) names.push_back(std::string("in_") + port.name);
   for (const RegisterView& shown : registers) names.push_back(shown.name);
   sink.names(names);
   std::vector<uint32_t> settings(std::size_t(stimulus.ports.count));
   auto change = stimulus.settings.begin();
   auto reset = stimulus.resets.begin();
   std::vector<TraceSink::Value> values;
   const auto add = [&values](uint64_t word) { values.push_back({word, false}); };
   for (uint64_t clock = 0; clock < stimulus.clocks.size(); ++clock) {
      const WideInput& in = stimulus.clocks[clock];
      if (change != stimulus.settings.end() && change->clock == clock) core->set(settings = change++->values);
      const PostOutput output = core->output();
      values.clear();
      add(lane_word<uint16_t>(in.left, pixels, module.shape.pixel_bits));
      add(lane_word<uint16_t>(in.right, pixels, module.shape.pixel_bits));
      add(in.start_of_frame);
      add(in.valid);
      add(lane_word<uint32_t>(output_lanes(output, layout), pixels, module.shape.disparity_bits));
      add(lane_word<bool>(output.pixel_valid, pixels, 1));
      add(output.valid);
      add(output.start_of_frame);
      add(output.end_of_line);
      for (const uint32_t setting : settings) add(setting);
      for (const RegisterView& shown : registers) values.push_back(shown.value());
      if (clock >= first) sink.clock(values);
      if (reset != stimulus.resets.end() && *reset == clock) {
         core = module.make(memories);
         registers = core->registers();
         if (change != stimulus.settings.begin()) core->set(settings);
         ++reset;
      } else {
         core->clock(in);
      }
   }
}

std::unique_ptr<TraceSink> text_trace(const std::string& config, std::size_t clocks, std::ostream& out) {
   out << "stereo-hls trace 1 config=" << config << " clocks=" << clocks << '\n';
   return std::make_unique<TextTrace>(out);
}

void trace_core(const CoreModule& module, const Stimulus& stimulus, std::ostream& out, uint64_t first) {
   trace_core(module, stimulus, *text_trace(stimulus.config, stimulus.clocks.size() - first, out), first);
}

namespace {

/// Not those of the tests, which change with what the tests should find: whether two registers of the core show the
/// same in all clocks, and so the names in the VHDL, may hang on the settings.
std::vector<uint32_t> trace_settings(const SettingList& ports, Random& random) {
   std::vector<uint32_t> values;
   for (const Setting& port : ports) {
      if (port.held) {
         values.push_back(uint32_t(port.start));
         continue;
      }
      const int span = port.largest - port.least;
      const int most = random.percent(50) ? span : std::min(span, 1 + span / 8);
      const int above = random.percent(15) ? 0 : random.below(most + 1);
      const bool from_top = std::string_view(port.name) == "last_disparity";
      values.push_back(uint32_t(from_top ? port.largest - above : port.least + above));
   }
   return values;
}

/// Without resets the size of the images may only grow: a counter that has passed the last column of a smaller image
/// would leave the memories. Where addresses fall, that of a row that grows would, too: the width changes only while
/// the core is empty, that is in the first `empty` clocks.
std::vector<SizeChange> growing_sizes(const CoreShape& shape, int empty, uint64_t clocks, Random& random) {
   constexpr int kSizes = 8, kClocksOfAWidth = 2;
   std::vector<SizeChange> sizes;
   for (int clock = 0; clock < empty; clock += kClocksOfAWidth) {
      const Image size = random_size(shape, random);
      sizes.push_back({uint64_t(clock), size.width_px, size.height_px});
   }
   Image least = shape.image;
   for (const Setting& port : shape.settings)
      if (port.held) (std::string_view(port.name) == "image_width" ? least.width_px : least.height_px) = port.least;
   for (int i = 0; i < kSizes; ++i) {
      const int more = shape.turns_rows ? 0 : (shape.image.width_px - least.width_px) * i / (kSizes - 1);
      const int groups =
          least.row_groups() + (shape.image.row_groups() - least.row_groups()) * i * i / ((kSizes - 1) * (kSizes - 1));
      const uint64_t clock = uint64_t(empty) + (clocks - uint64_t(empty)) * uint64_t(i) / kSizes;
      sizes.push_back({clock, least.width_px + more, groups * shape.image.pixels_per_clock});
   }
   return sizes;
}

}  // namespace

Stimulus make_trace_stimulus(const std::string& config, const CoreShape& shape, int clocks) {
   constexpr int kStallPercent = 20;
   constexpr uint64_t kSeed = 1;
   const Image& image = shape.image;
   StimulusWriter writer(shape, kStallPercent, kSeed);
   const int empty = has_size_ports(shape.settings) && shape.turns_rows ? 24 : 0;
   writer.bubbles(empty + 4);
   const auto records_of_a_frame = [&writer](int count) {
      writer.record({.left = {0x5a}, .right = {0xa5}, .start_of_frame = true, .valid = true});
      writer.random_records(count - 1);
   };
   records_of_a_frame(image.width_px / 2);
   while (writer.clocks.size() < std::size_t(clocks)) {
      records_of_a_frame(image.width_px * image.row_groups());
      writer.gap(shape.schedule);
   }
   writer.clocks.resize(std::size_t(clocks));
   Stimulus stimulus{config, image.pixels_per_clock, std::move(writer.clocks)};
   const SettingList& ports = shape.settings;
   Random random(kSeed);
   const auto next = [&] { return trace_settings(ports, random); };
   set_frames(stimulus, ports, random, next, growing_sizes(shape, empty, stimulus.clocks.size(), random));
   return stimulus;
}

}  // namespace stereo
