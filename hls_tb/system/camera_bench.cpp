// SPDX-License-Identifier: Apache-2.0
// Plays two cameras into a camera_system and writes down every beat of m_axis. It judges nothing: scripts/flow/system/
// does.
//   bench STREAM OBSERVED
// STREAM: "t ADDRESS DATA" for each write to the tables, in hexadecimal; then "l GAP PIXEL FLAGS" and "r GAP PIXEL
// FLAGS" for each beat of a camera, GAP clocks after the one before (flags: 1 start of frame, 2 end of line); "s
// PERCENT SEED": how often the sink waits. OBSERVED: "t RESPONSE" for each write; "o DATA FLAGS CLOCK" for each beat
// (flags: 1 start of frame, 2 frame error, 4 end of line); "e CAMERA CLOCK" at each end of line of a camera; "end
// CLOCKS".
#include <cstdio>
#include <random>
#include <type_traits>
#include <utility>
#include <vector>

#include "Vdesign.h"
#include "verilated.h"

namespace {

constexpr long kQuietClocks = 4000;
constexpr long kProgressClocks = 20000;

/// Of a pixel in the stream of a camera: 8 or 16 bits.
using Lane = std::remove_reference_t<decltype(std::declval<Vdesign&>().s_left_axis_tdata)>;

struct Beat {
   long gap;
   unsigned pixel, flags;
};

/// One camera: it sends without waiting.
struct Camera {
   std::vector<Beat> beats;
   std::size_t next = 0;
   long waited = 0;

   bool ended() const { return next == beats.size(); }
   /// The beat of this clock, or nullptr.
   const Beat* clock() {
      if (ended() || waited++ < beats[next].gap) return nullptr;
      waited = 0;
      return &beats[next++];
   }
};

void edge(Vdesign& model) {
   model.aclk = 0;
   model.eval();
   model.aclk = 1;
   model.eval();
}

/// A write on AXI4-Lite; returns the response.
unsigned write_table(Vdesign& model, unsigned address, unsigned data) {
   model.s_tables_axil_awaddr = static_cast<unsigned char>(address);
   model.s_tables_axil_wdata = data;
   model.s_tables_axil_awvalid = model.s_tables_axil_wvalid = 1;
   model.s_tables_axil_bready = 1;
   for (int clock = 0; clock < 100; ++clock) {
      model.aclk = 0;
      model.eval();
      const bool taken = model.s_tables_axil_awready && model.s_tables_axil_wready;
      const bool answered = model.s_tables_axil_bvalid;
      const unsigned response = model.s_tables_axil_bresp;
      edge(model);
      if (taken) model.s_tables_axil_awvalid = model.s_tables_axil_wvalid = 0;
      if (answered) return response;
   }
   return 99;  // no answer
}

}  // namespace

int main(int argc, char** argv) {
   std::FILE* stream = argc == 3 ? std::fopen(argv[1], "r") : nullptr;
   std::FILE* observed = argc == 3 ? std::fopen(argv[2], "w") : nullptr;
   if (!stream || !observed) {
      std::fprintf(stderr, "usage: bench STREAM OBSERVED\n");
      return 2;
   }
   Vdesign model;
   model.s_axil_awvalid = model.s_axil_wvalid = model.s_axil_arvalid = 0;
   model.s_axil_bready = model.s_axil_rready = 1;
   model.s_tables_axil_awvalid = model.s_tables_axil_wvalid = model.s_tables_axil_arvalid = 0;
   model.s_tables_axil_rready = 1;
   model.s_left_axis_tvalid = model.s_right_axis_tvalid = 0;
   model.aresetn = 0;
   for (int clock = 0; clock < 3; ++clock) edge(model);
   model.aresetn = 1;

   Camera cameras[2];
   int sink_percent = 0;
   std::mt19937 random;
   char kind;
   while (std::fscanf(stream, " %c", &kind) == 1) {
      unsigned first, second;
      Beat beat;
      if (kind == 't' && std::fscanf(stream, "%x %x", &first, &second) == 2) {
         std::fprintf(observed, "t %u\n", write_table(model, first, second));
      } else if (kind == 's' && std::fscanf(stream, "%d %u", &sink_percent, &second) == 2) {
         random.seed(second);
      } else if ((kind == 'l' || kind == 'r') &&
                 std::fscanf(stream, "%ld %x %u", &beat.gap, &beat.pixel, &beat.flags) == 3) {
         cameras[kind == 'r' ? 1 : 0].beats.push_back(beat);
      } else {
         std::fprintf(stderr, "a line of the stream is damaged\n");
         return 2;
      }
   }
   long clock = 0, last = 0;
   while (!cameras[0].ended() || !cameras[1].ended() || clock - last < kQuietClocks) {
      const Beat* const left = cameras[0].clock();
      const Beat* const right = cameras[1].clock();
      model.s_left_axis_tvalid = left != nullptr;
      model.s_left_axis_tdata = static_cast<Lane>(left ? left->pixel : random());
      model.s_left_axis_tuser = left ? left->flags & 1 : random() & 1;
      model.s_left_axis_tlast = left ? left->flags >> 1 & 1 : random() & 1;
      model.s_right_axis_tvalid = right != nullptr;
      model.s_right_axis_tdata = static_cast<Lane>(right ? right->pixel : random());
      model.s_right_axis_tuser = right ? right->flags & 1 : random() & 1;
      model.s_right_axis_tlast = right ? right->flags >> 1 & 1 : random() & 1;
      model.m_axis_tready = int(random() % 100) >= sink_percent;
      model.aclk = 0;
      model.eval();
      if (left && left->flags & 2) std::fprintf(observed, "e 0 %ld\n", clock);
      if (right && right->flags & 2) std::fprintf(observed, "e 1 %ld\n", clock);
      if (left || right) last = clock;
      if (model.m_axis_tvalid && model.m_axis_tready) {
         std::fprintf(observed, "o %llx %d %ld\n", static_cast<unsigned long long>(model.m_axis_tdata),
                      model.m_axis_tuser | model.m_axis_tlast << 2, clock);
         last = clock;
      }
      model.aclk = 1;
      model.eval();
      if (++clock % kProgressClocks == 0) std::printf("progress %ld\n", clock), std::fflush(stdout);
   }
   std::fprintf(observed, "end %ld\n", clock);
   return std::fclose(observed) == 0 ? 0 : 1;
}
