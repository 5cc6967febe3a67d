// SPDX-License-Identifier: Apache-2.0
// The Verilator twin of tb_stereo_core.vhd: drives the model with a stimulus file, writes down every output with its
// clock, judges nothing.
//   bench STIMULUS OBSERVED [WAVE FIRST_CLOCK LAST_CLOCK]
#include <cstdio>
#include <cstdlib>
#include <memory>

#include "Vdesign.h"
#include "verilated.h"
#if VM_TRACE
#include "verilated_fst_c.h"
#endif

namespace {

constexpr long kProgressClocks = 1000;

/// Dumps the model's signals while the clock count is in the window.
class Wave {
  public:
   Wave(Vdesign& model, int argc, char** argv) {
      if (argc < 6) return;
#if VM_TRACE
      first_clock_ = std::atol(argv[4]);
      last_clock_ = std::atol(argv[5]);
      file_ = std::make_unique<VerilatedFstC>();
      model.trace(file_.get(), 99);
      file_->open(argv[3]);
#else
      (void)model, (void)argv;
      std::fprintf(stderr, "this bench was built without tracing\n");
      std::exit(1);
#endif
   }
   void dump([[maybe_unused]] long clock, [[maybe_unused]] int phase) {
#if VM_TRACE
      if (file_ && clock >= first_clock_ && clock <= last_clock_)
         file_->dump(static_cast<vluint64_t>(10 * clock + 5 * phase));
#endif
   }
   void close() {
#if VM_TRACE
      if (file_) file_->close();
#endif
   }

  private:
#if VM_TRACE
   std::unique_ptr<VerilatedFstC> file_;
   long first_clock_ = 0;
   long last_clock_ = 0;
#endif
};

/// Ports are as wide as the pixels of one clock.
template <class Port>
void drive(Port& port, unsigned value) {
   port = static_cast<Port>(value);
}

/// The words of a line behind the pixels, for a core that has these ports.
template <class Model>
bool read_settings(Model& model, std::FILE* stimulus) {
   bool complete = true;
   const auto take = [&](auto& port) {
      unsigned value = 0;
      complete = complete && std::fscanf(stimulus, "%x", &value) == 1;
      drive(port, value);
   };
   if constexpr (requires { model.texture_threshold; }) take(model.texture_threshold);
   if constexpr (requires { model.uniqueness_percent; }) take(model.uniqueness_percent);
   if constexpr (requires { model.left_right_threshold; }) take(model.left_right_threshold);
   return complete;
}

void clock_edge(Vdesign& model, Wave& wave, long clock) {
   model.clock = 0;
   model.eval();
   wave.dump(clock, 0);
   model.clock = 1;
   model.eval();
   wave.dump(clock, 1);
}

}  // namespace

int main(int argc, char** argv) {
   if (argc != 3 && argc != 6) {
      std::fprintf(stderr, "usage: bench STIMULUS OBSERVED [WAVE FIRST_CLOCK LAST_CLOCK]\n");
      return 2;
   }
   std::FILE* stimulus = std::fopen(argv[1], "r");
   std::FILE* observed = std::fopen(argv[2], "w");
   if (!stimulus || !observed) {
      std::fprintf(stderr, "cannot open %s\n", stimulus ? argv[2] : argv[1]);
      return 2;
   }
   if (argc == 6) Verilated::traceEverOn(true);
   Vdesign model;
   Wave wave(model, argc, argv);

   model.reset = 1;
   for (long clock = -2; clock < 0; ++clock) clock_edge(model, wave, clock);
   model.reset = 0;

   char line[256];
   if (!std::fgets(line, sizeof line, stimulus)) return 2;  // format line, checked before the simulation starts
   long clock = 0;
   unsigned flags, left, right;
   while (std::fscanf(stimulus, "%x %x %x", &flags, &left, &right) == 3 && read_settings(model, stimulus)) {
      model.valid = flags & 1;
      model.start_of_frame = flags >> 1 & 1;
      model.reset = flags >> 2 & 1;
      drive(model.left_pixel, left);
      drive(model.right_pixel, right);
      model.clock = 0;
      model.eval();
      if (model.disparity_valid)
         std::fprintf(observed, "%ld %llx %u\n", clock, static_cast<unsigned long long>(model.disparity),
                      model.disparity_start_of_frame | model.disparity_end_of_line << 1 | model.pixel_valid << 2);
      clock_edge(model, wave, clock);
      if (++clock % kProgressClocks == 0) std::printf("progress %ld\n", clock), std::fflush(stdout);
   }
   std::fprintf(observed, "end %ld\n", clock);
   wave.close();
   return std::fclose(observed) == 0 ? 0 : 1;
}
