// SPDX-License-Identifier: Apache-2.0
// Runs a design with many faults to choose from (scripts/flow/mutation/schemata.py) once for each, up to the first
// output that is not the one without a fault, and writes down where that was.
//   mutants_bench STIMULUS OBSERVED RESULT MUTANTS
// MUTANTS has the number of a fault in each line. OBSERVED is written as verilator_bench.cpp does, without a fault.
// RESULT has a line "NUMBER CLOCK" for each fault that shows.
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <vector>

#include "bench_stimulus.hpp"
#include "verilated.h"

namespace {

struct Record {
   unsigned long long fields[kFields];
};

struct Output {
   long clock;
   unsigned long long word, flags;
   bool operator==(const Output&) const = default;
};

std::vector<Record> read_stimulus(std::FILE* file) {
   std::vector<Record> records;
   if (!skip_format(file)) return records;
   for (Record record; read_fields(file, record.fields);) records.push_back(record);
   return records;
}

std::vector<int> read_numbers(std::FILE* file) {
   std::vector<int> numbers;
   for (int number; std::fscanf(file, "%d", &number) == 1;) numbers.push_back(number);
   return numbers;
}

/// Gives each output to `is_as_wanted`, until it says no; returns the clock of that, or -1.
template <class Judge>
long play(const std::vector<Record>& stimulus, int mutant, Judge is_as_wanted) {
   const auto model = std::make_unique<Vdesign>();
   model->mutant_number = mutant;
   reset(*model, [](long, int) {});
   for (long clock = 0; clock < static_cast<long>(stimulus.size()); ++clock) {
      show_outputs(*model, stimulus[static_cast<std::size_t>(clock)].fields);
      if (!is_as_wanted(clock, is_valid(*model), Output{clock, word(*model), shown_flags(*model)})) return clock;
      clock_edge(*model, [](int) {});
   }
   return -1;
}

}  // namespace

int main(int argc, char** argv) {
   if (argc != 5) {
      std::fprintf(stderr, "usage: mutants_bench STIMULUS OBSERVED RESULT MUTANTS\n");
      return 2;
   }
   std::FILE* file = std::fopen(argv[1], "r");
   std::FILE* observed = std::fopen(argv[2], "w");
   std::FILE* result = std::fopen(argv[3], "w");
   std::FILE* mutants = std::fopen(argv[4], "r");
   if (!file || !observed || !result || !mutants) {
      std::fprintf(stderr, "cannot open a file\n");
      return 2;
   }
   const std::vector<Record> stimulus = read_stimulus(file);
   std::vector<Output> wanted;
   play(stimulus, 0, [&](long, bool valid, const Output& output) {
      if (valid) wanted.push_back(output);
      return true;
   });
   for (const Output& output : wanted) write_output(observed, output.clock, output.word, output.flags);
   write_end(observed, static_cast<long>(stimulus.size()));
   int played = 0;
   for (const int mutant : read_numbers(mutants)) {
      auto next = wanted.begin();
      const long clock = play(stimulus, mutant, [&](long now, bool valid, const Output& output) {
         const bool comes = next != wanted.end() && next->clock == now;
         if (comes != valid) return false;
         return !valid || output == *next++;
      });
      if (clock >= 0) std::fprintf(result, "%d %ld\n", mutant, clock);
      if (++played % 10 == 0) std::printf("progress %d\n", played), std::fflush(stdout);
   }
   return std::fclose(observed) == 0 && std::fclose(result) == 0 ? 0 : 1;
}
