// SPDX-License-Identifier: Apache-2.0
// Plays a stream of scripts/flow/shell/script.py into stereo_ip and writes down every beat of m_axis. It judges nothing
// but the protocol: contract.py compares.
//   bench STREAM OBSERVED
// OBSERVED: "o DATA FLAGS CLOCK" for each beat (flags: 1 start of frame, 2 frame error, 4 end of line), "r" at a reset,
// "p SENTENCE" for a breach of the protocol, then "end CLOCKS" or "hang CLOCK".
#include <array>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <random>

#include "Vdesign.h"
#include "verilated.h"

namespace {

constexpr long kHangClocks = 200000;  // without a beat on either side while beats wait; the sink takes 1 in 10 at least
constexpr long kProgressClocks = 20000;
constexpr int kAnswerClocks = 100;  // of a register

/// A beat of m_axis in words of 32 bits, the lowest first.
using Beat = std::array<uint32_t, 3>;
static_assert(sizeof(Vdesign::m_axis_tdata) <= sizeof(Beat), "this bench takes beats of at most 96 bits");

/// Verilator keeps ports of up to 64 bits as integers, wider ones as arrays.
template <class Port>
Beat beat_of(const Port& port) {
   if constexpr (sizeof(Port) > 8) return {port[0], port[1], port[2]};
   else return {uint32_t(port), uint32_t(uint64_t(port) >> 32), 0};
}

/// Ports are as wide as the beats of the configuration.
template <class Port>
void drive(Port& port, uint64_t value) {
   port = static_cast<Port>(value);
}

class Bench {
  public:
   Bench(std::FILE* observed, unsigned seed) : observed_(observed), random_(seed) {
      model_.s_axil_awvalid = model_.s_axil_wvalid = model_.s_axil_arvalid = 0;
      model_.s_axil_bready = model_.s_axil_rready = 1;
      reset(2);
   }

   void set_rates(int source, int sink) { source_percent_ = source, sink_percent_ = sink; }

   /// Offers a beat until it is taken.
   void send(uint64_t data, int flags) {
      while (chance(source_percent_)) idle(1);
      model_.s_axis_tvalid = 1;
      drive(model_.s_axis_tdata, data);
      model_.s_axis_tuser = flags & 1;
      model_.s_axis_tlast = flags >> 1 & 1;
      while (!clock()) {
      }
      model_.s_axis_tvalid = 0;
      garbage();
   }
   void idle(long clocks) {
      while (clocks-- > 0) clock();
   }
   /// A register, with nothing on s_axis meanwhile.
   void write(unsigned address, uint32_t value) {
      model_.s_axil_awaddr = address;
      model_.s_axil_wdata = value;
      model_.s_axil_wstrb = 15;
      model_.s_axil_awvalid = model_.s_axil_wvalid = 1;
      bool answered = false;
      for (int i = 0; i < kAnswerClocks && !answered; ++i) {
         const bool address_taken = model_.s_axil_awready, data_taken = model_.s_axil_wready;
         answered = model_.s_axil_bvalid;
         clock();
         if (address_taken) model_.s_axil_awvalid = 0;
         if (data_taken) model_.s_axil_wvalid = 0;
      }
      if (!answered) std::fprintf(observed_, "p no answer to a write of register %02x, clock %ld\n", address, clock_);
   }
   void read(unsigned address, uint32_t expected, uint32_t mask) {
      model_.s_axil_araddr = address;
      model_.s_axil_arvalid = 1;
      bool answered = false;
      for (int i = 0; i < kAnswerClocks && !answered; ++i) {
         const bool taken = model_.s_axil_arready;
         answered = model_.s_axil_rvalid;
         if (answered && ((model_.s_axil_rdata ^ expected) & mask) != 0)
            std::fprintf(observed_, "p register %02x: expected %x, got %x, clock %ld\n", address, expected & mask,
                         model_.s_axil_rdata & mask, clock_);
         clock();
         if (taken) model_.s_axil_arvalid = 0;
      }
      if (!answered) std::fprintf(observed_, "p no answer to a read of register %02x, clock %ld\n", address, clock_);
   }
   void expect_interrupt(int level) {
      if (model_.irq != level) std::fprintf(observed_, "p irq is not %d, clock %ld\n", level, clock_);
   }
   void drain(long quiet_clocks) {
      while (clock_ - last_beat_ < quiet_clocks) clock();
   }
   void reset(long clocks) {
      std::fprintf(observed_, "r\n");
      model_.aresetn = 0;
      model_.s_axis_tvalid = 0;
      waiting_ = false;
      while (clocks-- > 0) clock();
      model_.aresetn = 1;
      last_beat_ = clock_;
   }
   long clocks() const { return clock_; }

  private:
   bool chance(int percent) { return percent > 0 && int(random_() % 100) < percent; }
   void garbage() {
      drive(model_.s_axis_tdata, random_());
      model_.s_axis_tuser = random_() & 1;
      model_.s_axis_tlast = random_() & 1;
   }
   void write_beat(const Beat& beat) const {
      std::fprintf(observed_, "o %x%08x%08x %d %ld\n", beat[2], beat[1], beat[0], flags(), clock_);
   }
   int flags() const { return model_.m_axis_tuser | model_.m_axis_tlast << 2; }

   /// One clock; true when a beat of s_axis was taken.
   bool clock() {
      model_.m_axis_tready = !chance(sink_percent_);
      model_.aclk = 0;
      model_.eval();
      check_protocol();
      const bool taken = model_.aresetn && model_.s_axis_tvalid && model_.s_axis_tready;
      const bool given = model_.aresetn && model_.m_axis_tvalid && model_.m_axis_tready;
      if (given) write_beat(beat_of(model_.m_axis_tdata));
      if (taken || given) last_beat_ = clock_;
      model_.aclk = 1;
      model_.eval();
      if (++clock_ % kProgressClocks == 0) std::printf("progress %ld\n", clock_), std::fflush(stdout);
      if (model_.s_axis_tvalid && clock_ - last_beat_ > kHangClocks) {
         std::fprintf(observed_, "hang %ld\n", clock_);
         std::fclose(observed_);
         std::exit(0);
      }
      return taken;
   }

   /// A beat that is offered stays as it is until it is taken; nothing is offered or taken in reset.
   void check_protocol() {
      const bool valid = model_.m_axis_tvalid;
      if (waiting_ && (!valid || beat_of(model_.m_axis_tdata) != data_ || flags() != flags_))
         std::fprintf(observed_, "p m_axis changed before it was taken, clock %ld\n", clock_);
      waiting_ = model_.aresetn && valid && !model_.m_axis_tready;
      data_ = beat_of(model_.m_axis_tdata);
      flags_ = flags();
      if (!model_.aresetn && was_reset_ && (valid || model_.s_axis_tready))
         std::fprintf(observed_, "p m_axis_tvalid or s_axis_tready in reset, clock %ld\n", clock_);
      was_reset_ = !model_.aresetn;
   }

   Vdesign model_;
   std::FILE* observed_;
   std::mt19937 random_;
   int source_percent_ = 0, sink_percent_ = 0;
   long clock_ = 0, last_beat_ = 0;
   bool waiting_ = false, was_reset_ = false;
   Beat data_{};
   int flags_ = 0;
};

void play(std::FILE* stream, Bench& bench) {
   constexpr long kQuietClocks = 5000;
   char kind;
   unsigned long long first = 0;
   long second = 0;
   unsigned address = 0, value = 0, mask = 0;
   while (std::fscanf(stream, " %c", &kind) == 1) {
      if (kind == 'b' && std::fscanf(stream, "%llx %ld", &first, &second) == 2) bench.send(first, int(second));
      else if (kind == 'p' && std::fscanf(stream, "%llu %ld", &first, &second) == 2)
         bench.set_rates(int(first), int(second));
      else if (kind == 'i' && std::fscanf(stream, "%ld", &second) == 1) bench.idle(second);
      else if (kind == 'r' && std::fscanf(stream, "%ld", &second) == 1) bench.reset(second);
      else if (kind == 'w' && std::fscanf(stream, "%u %u", &address, &value) == 2) bench.write(address, value);
      else if (kind == 'q' && std::fscanf(stream, "%u %u %u", &address, &value, &mask) == 3)
         bench.read(address, value, mask);
      else if (kind == 'l' && std::fscanf(stream, "%ld", &second) == 1) bench.expect_interrupt(int(second));
      else if (kind == 'd') bench.drain(kQuietClocks);
      else std::fprintf(stderr, "bad step '%c'\n", kind), std::exit(2);
   }
}

}  // namespace

int main(int argc, char** argv) {
   if (argc != 3) {
      std::fprintf(stderr, "usage: bench STREAM OBSERVED\n");
      return 2;
   }
   std::FILE* stream = std::fopen(argv[1], "r");
   std::FILE* observed = std::fopen(argv[2], "w");
   unsigned seed = 0;
   if (!stream || !observed) {
      std::fprintf(stderr, "cannot open %s\n", stream ? argv[2] : argv[1]);
      return 2;
   }
   if (std::fscanf(stream, "stereo-hls stream 1 seed=%u", &seed) != 1) {
      std::fprintf(stderr, "%s: no stream of format 1\n", argv[1]);
      return 2;
   }
   Bench bench(observed, seed);
   play(stream, bench);
   std::fprintf(observed, "end %ld\n", bench.clocks());
   return std::fclose(observed) == 0 ? 0 : 1;
}
