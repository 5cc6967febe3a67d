// SPDX-License-Identifier: Apache-2.0
#include "program/commands/vectors_command.hpp"

#include <CLI/CLI.hpp>
#include <iostream>
#include <sstream>

#include "cosim/stage_files.hpp"
#include "cosim/vector_files.hpp"
#include "engines/clocked/core_modules.hpp"
#include "engines/clocked/run_core.hpp"
#include "program/commands/named_matching.hpp"
#include "program/commands/stream_options.hpp"
#include "program/io/output_folder.hpp"

namespace stereo::app {
namespace {

template <class Writer, class... Content>
std::string text_of(Writer write, const Content&... content) {
   std::ostringstream out;
   write(out, content...);
   return out.str();
}

struct VectorsArguments {
   std::string config, out;
   StreamArguments stream;
};

void write(const VectorsArguments& arguments, uint64_t images_from, std::size_t clocks, std::size_t outputs,
           std::string stimulus, std::string expected) {
   OutputFolder out(arguments.out);
   out.add("stimulus.txt", std::move(stimulus));
   out.add("expected.txt", std::move(expected));
   std::cout << clocks << " clocks, " << outputs << " outputs\n";
   if (images_from > 0) std::cout << "the images begin at clock " << images_from << "\n";
   out.commit();
}

void vectors_of_stage(const VectorsArguments& arguments, const Stage& stage) {
   const Stream stream = make_stream(arguments.stream, stage.name, stage.shape);
   const std::vector<StageClock> clocks = make_stage_stimulus(stage, stream.stimulus, arguments.stream.options.seed);
   const std::vector<StageOutput> outputs = run_stage(stage, clocks);
   write(arguments, stream.images_from, clocks.size(), outputs.size(), text_of(write_stage_stimulus, stage, clocks),
         text_of(write_stage_expected, stage, outputs));
}

void vectors(const VectorsArguments& arguments) {
   if (const Stage* const stage = find_stage(arguments.config)) return vectors_of_stage(arguments, *stage);
   const CoreModule& core = core_module(require_configuration(arguments.config).name);
   const auto [stimulus, images_from] = make_stream(arguments.stream, core.name, core.shape);
   const Expected expected{core.name,
                           core.shape.image.pixels_per_clock,
                           core.shape.disparity_bits,
                           core.shape.schedule.latency_clocks,
                           run_core(core, stimulus),
                           core.shape.has_confidence,
                           core.shape.has_filled};
   write(arguments, images_from, stimulus.clocks.size(), expected.outputs.size(), text_of(write_stimulus, stimulus),
         text_of(write_expected, expected));
}

}  // namespace

void add_vectors(CLI::App& app) {
   static VectorsArguments arguments;
   CLI::App* command = app.add_subcommand("vectors", "make test vectors for the hardware: stimulus.txt, expected.txt");
   command->add_option("--config", arguments.config, "configuration")->required();
   command->add_option("--out", arguments.out, "folder for the results")->required();
   add_stream_options(*command, arguments.stream);
   command->callback([] { vectors(arguments); });
}

}  // namespace stereo::app
