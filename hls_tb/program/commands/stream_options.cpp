// SPDX-License-Identifier: Apache-2.0
#include "program/commands/stream_options.hpp"

#include <charconv>

#include "engines/clocked/stress.hpp"
#include "engines/configurations.hpp"
#include "program/commands/checks.hpp"
#include "program/commands/pair_options.hpp"
#include "program/errors.hpp"

namespace stereo::app {
namespace {

RowRange parse_rows(const std::string& text) {
   RowRange rows;
   const char* const end = text.data() + text.size();
   const auto first = std::from_chars(text.data(), end, rows.first);
   if (first.ec == std::errc() && first.ptr != end && *first.ptr == ':') {
      const auto last = std::from_chars(first.ptr + 1, end, rows.end);
      if (last.ec == std::errc() && last.ptr == end) return rows;
   }
   throw InputError("--rows " + text + ": must be A:B, the first row and the one after the last, such as 10:20");
}

/// That of the images.
Stimulus stream_of_images(const StreamArguments& arguments, const std::string& config, const CoreShape& shape) {
   const Image& image = shape.image;
   StimulusOptions options = arguments.options;
   if (!arguments.rows.empty()) options.rows = parse_rows(arguments.rows);
   const auto stream_of = [&](auto loaded) {
      const auto pair = fit_pair(std::move(loaded), image.width_px, image.height_px, arguments.fit);
      if (arguments.broken == 0) return make_stimulus(config, shape, pair, options);
      return make_broken_stimulus(config, shape, pair, arguments.broken, options.stall_percent, options.seed);
   };
   if (shape.pixel_bits > 8) return stream_of(load_deep_pair(arguments.left, arguments.right, shape.pixel_bits));
   return stream_of(load_pair(arguments.left, arguments.right));
}

/// Those of its family; a stage has none.
std::vector<DeepPair> own_stress_pairs(const std::string& config, uint64_t seed) {
   const Configuration* const known = find_configuration(config);
   if (known == nullptr) return {};
   Random random(seed);
   return known->algorithm->own_stress_pairs(known->shape.image.width_px, known->shape.image.height_px, random);
}

}  // namespace

Stream make_stream(const StreamArguments& arguments, const std::string& config, const CoreShape& shape) {
   const bool has_images = !arguments.left.empty();
   if (!arguments.stress && !has_images) throw InputError("nothing to send: give --stress, or --left and --right");
   if (!arguments.stress) return {stream_of_images(arguments, config, shape)};
   Stream stream{make_stress_stimulus(config, shape, arguments.options.seed, std::size_t(arguments.stress_clocks),
                                      own_stress_pairs(config, arguments.options.seed))};
   if (has_images) stream.images_from = append(stream.stimulus, stream_of_images(arguments, config, shape));
   return stream;
}

void add_stream_options(CLI::App& command, StreamArguments& arguments) {
   StimulusOptions& options = arguments.options;
   CLI::Option* const rows = command.add_option("--rows", arguments.rows, "send only image rows A:B, B excluded");
   CLI::Option* const frames =
       command.add_option("--frames", options.frames, "frames back to back, odd ones upside down")
           ->check(CLI::Range(1, 1000))
           ->capture_default_str();
   command
       .add_option(
           "--broken", arguments.broken,
           "send this many stream faults instead of frames: broken frames, records without start of frame, resets")
       ->check(CLI::Range(1, 1000))
       ->excludes(frames)
       ->excludes(rows);
   command.add_option("--stall-percent", options.stall_percent, "chance of a bubble before a pixel pair")
       ->check(CLI::Range(0, 95))
       ->capture_default_str();
   command.add_option("--seed", options.seed, "seed of the bubbles and flush rows")
       ->capture_default_str()
       ->check(check_seed);
   add_pair_options(command, arguments.left, arguments.right, arguments.fit);
   CLI::Option* const stress =
       command.add_flag("--stress", arguments.stress, "send the stress stream first, then the images");
   command
       .add_option("--stress-clocks", arguments.stress_clocks,
                   "streams of other seeds follow until there are so many clocks of stress")
       ->check(CLI::Range(1, 100'000'000))
       ->capture_default_str()
       ->needs(stress);
   CLI::Option* const left = command.get_option("--left")->required(false);
   CLI::Option* const right = command.get_option("--right")->required(false);
   left->needs(right);
   for (const char* const name : {"--right", "--fit", "--rows", "--frames", "--broken", "--stall-percent"})
      command.get_option(name)->needs(left);
}

}  // namespace stereo::app
