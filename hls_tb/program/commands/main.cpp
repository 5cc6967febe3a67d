// SPDX-License-Identifier: Apache-2.0
#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <stdexcept>

#include "engines/clocked/core_modules.hpp"
#include "program/commands/checks.hpp"
#include "program/commands/configurations_command.hpp"
#include "program/commands/depth_command.hpp"
#include "program/commands/evaluate_command.hpp"
#include "program/commands/match_command.hpp"
#include "program/commands/options_command.hpp"
#include "program/commands/rectify_command.hpp"
#include "program/commands/scene_command.hpp"
#include "program/commands/standard_output.hpp"
#include "program/commands/trace_command.hpp"
#include "program/commands/vectors_command.hpp"
#include "program/commands/video_command.hpp"
#include "program/errors.hpp"

namespace {

using namespace stereo::app;

constexpr int kInternalError = 1;
constexpr int kInputError = 2;
constexpr int kMissingPart = 3;

/// One line, whatever the text holds.
int report(const std::string& problem, int exit_code) {
   std::string line = "stereo_hls: " + problem;
   std::replace(line.begin(), line.end(), '\n', ' ');
   std::cerr << line << '\n';
   return exit_code;
}

/// --help and --version.
int answer(const CLI::App& app, const CLI::ParseError& asked) {
   app.exit(asked);
   try {
      require_printed();
      return 0;
   } catch (const std::exception& error) {
      return report(std::string("internal failure: ") + error.what(), kInternalError);
   }
}

}  // namespace

int main(int argc, char** argv) {
   CLI::App app("Stereo matching as the hardware does it: fast models, clocked cores and test vectors.", "stereo_hls");
   app.set_version_flag("--version", STEREO_HLS_VERSION);
   app.require_subcommand(1);
   app.footer(
       "Exit codes: 0 success; 1 internal failure; 2 wrong usage or input; 3 a core that was not built, or another "
       "missing part. On failure one "
       "line on stderr says why, "
       "and nothing is written.");
   add_match(app);
   add_depth(app);
   add_rectify(app);
   add_evaluate(app);
   add_video(app);
   add_scene(app);
   add_vectors(app);
   add_trace(app);
   add_configurations(app);
   add_options(app);
   refuse_empty_values(app);
   try {
      app.parse(argc, argv);
      require_printed();
      return 0;
   } catch (const CLI::ParseError& error) {
      if (error.get_exit_code() == 0) return answer(app, error);
      if (argc > 1 && app.get_subcommands().empty())
         return report(std::string(argv[1]) + ": unknown command; see stereo_hls --help", kInputError);
      return report(std::string(error.what()) + "; see stereo_hls --help", kInputError);
   } catch (const InputError& error) {
      return report(error.what(), kInputError);
   } catch (const std::invalid_argument& error) {
      return report(error.what(), kInputError);
   } catch (const stereo::NoCoreModule& error) {
      return report(error.what(), kMissingPart);
   } catch (const MissingPart& error) {
      return report(error.what(), kMissingPart);
   } catch (const std::filesystem::filesystem_error& error) {  // a folder without rights, mostly
      return report(error.path1().string() + ": " + error.code().message(), kInputError);
   } catch (const std::exception& error) {
      return report(std::string("internal failure: ") + error.what(), kInternalError);
   }
}
