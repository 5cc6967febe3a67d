// SPDX-License-Identifier: Apache-2.0
// What the C++ benches of a core share: the lines of a stimulus, clocks, the lines of outputs. bench_ports.hpp, made by
// scripts/flow/cosim/bench.py, knows the ports of the design.
#pragma once

#include <cstdio>

#include "bench_ports.hpp"

/// Past the first line, which is checked before the simulation starts.
inline bool skip_format(std::FILE* stimulus) {
   char line[256];
   return std::fgets(line, sizeof line, stimulus) != nullptr;
}

/// The next line.
inline bool read_fields(std::FILE* stimulus, unsigned long long (&fields)[kFields]) {
   for (unsigned long long& field : fields)
      if (std::fscanf(stimulus, "%llx", &field) != 1) return false;
   return true;
}

/// `dump` gets each phase when it is over.
template <class Dump>
void clock_edge(Vdesign& model, Dump dump) {
   for (const int phase : {0, 1}) {
      model.clock = phase;
      model.eval();
      dump(phase);
   }
}

/// Two clocks, -2 and -1; `dump` gets them and their phases.
template <class Dump>
void reset(Vdesign& model, Dump dump) {
   model.reset = 1;
   for (long clock = -2; clock < 0; ++clock) clock_edge(model, [&](int phase) { dump(clock, phase); });
   model.reset = 0;
}

/// The outputs that go with these inputs.
inline void show_outputs(Vdesign& model, const unsigned long long (&fields)[kFields]) {
   drive_inputs(model, fields);
   model.clock = 0;
   model.eval();
}

inline void write_output(std::FILE* observed, long clock, unsigned long long word, unsigned long long flags) {
   std::fprintf(observed, "%ld %llx %llu\n", clock, word, flags);
}
inline void write_end(std::FILE* observed, long clocks) { std::fprintf(observed, "end %ld\n", clocks); }
