// SPDX-License-Identifier: Apache-2.0
#include "engines/rectification/stage_stimulus.hpp"

#include <algorithm>

namespace stereo {
namespace {

using rectification::TableWrite;

/// Writes the nodes of both tables one after the other, each time with other offsets.
class NodeWriter {
  public:
   NodeWriter(const rectification::Config& config, uint64_t seed) : config_(config), random_(seed ^ 0x7ab1e) {}

   int nodes() const { return 2 * config_.table_columns() * config_.table_rows(); }
   TableWrite next() {
      if (place_ % (nodes() / 2) == 0) begin_table();
      const int node = place_ % (nodes() / 2);
      const TableWrite write{true,
                             place_ >= nodes() / 2,
                             uint16_t(node % config_.table_columns()),
                             uint16_t(node / config_.table_columns()),
                             offset(),
                             offset()};
      place_ = (place_ + 1) % nodes();
      return write;
   }
   /// One at a random place.
   TableWrite any() {
      return {true,    random_.percent(50), below(config_.table_columns()), below(config_.table_rows()), offset(),
              offset()};
   }
   /// A clock without a node: its other ports show anything.
   TableWrite none() {
      TableWrite write = any();
      write.valid = false;
      return write;
   }
   bool percent(int chance) { return random_.percent(chance); }

  private:
   void begin_table() {
      const int most = config_.largest_offset();
      const int small = std::max(config_.rows_above, config_.rows_below) + 2;  // some beyond the rows that are kept
      reach_ = random_.percent(50) ? most : std::min(most, small << config_.offset_fraction_bits);
   }
   uint16_t below(int limit) { return uint16_t(random_.below(limit)); }
   int16_t offset() { return int16_t(random_.below(2 * reach_ + 2) - reach_ - 1); }

   const rectification::Config& config_;
   Random random_;
   int place_ = 0;
   int reach_ = 0;
};

constexpr int kWritesPercent = 1;  // of the clocks of a stream

}  // namespace

std::vector<StageClock> make_stage_stimulus(const Stage& stage, const Stimulus& stream, uint64_t seed) {
   NodeWriter nodes(stage.config, seed);
   std::vector<StageClock> clocks;
   const auto load = [&] {
      for (int left = nodes.nodes(); left > 0;) {
         const bool writes = !nodes.percent(20);
         clocks.push_back({{}, writes ? nodes.next() : nodes.none()});
         left -= writes ? 1 : 0;
      }
   };
   load();
   auto reset = stream.resets.begin();
   for (uint64_t clock = 0; clock < stream.clocks.size(); ++clock) {
      const bool resets = reset != stream.resets.end() && *reset == clock;
      if (resets) ++reset;
      const bool writes = !resets && nodes.percent(kWritesPercent);
      clocks.push_back({stream.clocks[clock], writes ? nodes.any() : nodes.none(), resets});
      const bool goes_on = reset != stream.resets.end() && *reset == clock + 1;
      if (resets && !goes_on) load();
   }
   return clocks;
}

std::vector<StageOutput> run_stage(const Stage& stage, const std::vector<StageClock>& clocks) {
   HeapMemories memories;
   auto core = stage.make(memories);
   std::vector<StageOutput> outputs;
   int starts = 0;
   for (uint64_t clock = 0; clock < clocks.size(); ++clock) {
      if (const WideInput out = core->output(); out.valid) {
         StageOutput next{clock, 0, 0, 0, out.left[0], out.right[0], out.start_of_frame};
         starts += out.start_of_frame ? 1 : 0;
         next.frame = std::max(starts - 1, 0);
         if (!outputs.empty() && !out.start_of_frame) {
            const bool ends = outputs.back().x == stage.config.width_px - 1;
            next.x = ends ? 0 : outputs.back().x + 1;
            next.y = outputs.back().y + (ends ? 1 : 0);
         }
         outputs.push_back(next);
      }
      if (clocks[clock].reset) core = stage.make(memories);
      else core->clock(clocks[clock].in, clocks[clock].node);
   }
   return outputs;
}

void trace_stage(const Stage& stage, const std::vector<StageClock>& clocks, std::ostream& out, uint64_t first) {
   HeapMemories memories;
   auto core = stage.make(memories);
   std::vector<RegisterView> registers = core->registers();
   std::vector<std::string> names{"in_left_pixel",
                                  "in_right_pixel",
                                  "in_start_of_frame",
                                  "in_valid",
                                  "in_node_valid",
                                  "in_node_right",
                                  "in_node_column",
                                  "in_node_row",
                                  "in_node_x",
                                  "in_node_y",
                                  "out_rectified_left",
                                  "out_rectified_right",
                                  "out_rectified_start_of_frame",
                                  "out_rectified_valid"};
   for (const RegisterView& shown : registers) names.push_back(shown.name);
   const std::unique_ptr<TraceSink> sink = text_trace(stage.name, clocks.size() - first, out);
   sink->names(names);
   std::vector<TraceSink::Value> values;
   const auto add = [&values](uint64_t word) { values.push_back({word, false}); };
   for (uint64_t clock = 0; clock < clocks.size(); ++clock) {
      const auto& [in, node, resets] = clocks[clock];
      const WideInput shown = core->output();
      values.clear();
      for (const uint64_t word :
           {uint64_t(in.left[0]), uint64_t(in.right[0]), uint64_t(in.start_of_frame), uint64_t(in.valid),
            uint64_t(node.valid), uint64_t(node.right), uint64_t(node.column), uint64_t(node.row),
            uint64_t(uint16_t(node.x)), uint64_t(uint16_t(node.y)), uint64_t(shown.left[0]), uint64_t(shown.right[0]),
            uint64_t(shown.start_of_frame), uint64_t(shown.valid)})
         add(word);
      for (const RegisterView& one : registers) values.push_back(one.value());
      if (clock >= first) sink->clock(values);
      if (resets) {
         core = stage.make(memories);
         registers = core->registers();
      } else {
         core->clock(in, node);
      }
   }
}

void trace_stage(const Stage& stage, int clocks, std::ostream& out) {
   constexpr uint64_t kSeed = 1;
   NodeWriter nodes(stage.config, kSeed);
   std::vector<StageClock> stream;
   for (const WideInput& in : make_trace_stimulus(stage.name, stage.shape, clocks).clocks)
      stream.push_back({in, nodes.percent(80) ? nodes.next() : nodes.none()});
   trace_stage(stage, stream, out);
}

}  // namespace stereo
