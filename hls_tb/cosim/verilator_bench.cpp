// SPDX-License-Identifier: Apache-2.0
// The Verilator twin of tb_stereo_core.vhd: drives the model with a stimulus file, writes down every output with its
// clock, judges nothing.
//   bench STIMULUS OBSERVED [WAVE FIRST_CLOCK LAST_CLOCK]
// Built for coverage it writes coverage.dat beside OBSERVED.
#include <cstdio>
#include <cstdlib>
#include <memory>

#include "bench_stimulus.hpp"
#include "verilated.h"
#if VM_TRACE
#include "verilated_fst_c.h"
#endif
#if VM_COVERAGE
#include <filesystem>

#include "verilated_cov.h"
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

   reset(model, [&](long clock, int phase) { wave.dump(clock, phase); });

   if (!skip_format(stimulus)) return 2;
   long clock = 0;
   unsigned long long fields[kFields];
   while (read_fields(stimulus, fields)) {
      show_outputs(model, fields);
      if (is_valid(model)) write_output(observed, clock, word(model), shown_flags(model));
      clock_edge(model, [&](int phase) { wave.dump(clock, phase); });
      if (++clock % kProgressClocks == 0) std::printf("progress %ld\n", clock), std::fflush(stdout);
   }
   write_end(observed, clock);
   wave.close();
#if VM_COVERAGE
   const auto data = std::filesystem::path(argv[2]).replace_filename("coverage.dat");
   Verilated::threadContextp()->coveragep()->write(data.c_str());
#endif
   return std::fclose(observed) == 0 ? 0 : 1;
}
