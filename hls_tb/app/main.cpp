// SPDX-License-Identifier: Apache-2.0
#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <stdexcept>

#include "app/commands.hpp"
#include "app/depth_command.hpp"
#include "app/errors.hpp"
#include "app/evaluate_command.hpp"
#include "app/match_command.hpp"
#include "app/standard_output.hpp"
#include "app/video_command.hpp"

namespace {

using namespace stereo::app;

constexpr int kInternalError = 1;
constexpr int kInputError = 2;

/// One line, whatever the text holds.
int report(const std::string& problem, int exit_code) {
   std::string line = "stereo_hls: " + problem;
   std::replace(line.begin(), line.end(), '\n', ' ');
   std::cerr << line << '\n';
   return exit_code;
}

}  // namespace

int main(int argc, char** argv) {
   CLI::App app("Stereo block matching as the hardware does it: fast model, clocked core and test vectors.",
                "stereo_hls");
   app.set_version_flag("--version", STEREO_HLS_VERSION);
   app.require_subcommand(1);
   app.footer(
       "Exit codes: 0 success; 1 internal failure; 2 wrong usage or input. On failure one line on stderr says why, "
       "and nothing is written.");
   add_match(app);
   add_depth(app);
   add_evaluate(app);
   add_video(app);
   add_scene(app);
   add_vectors(app);
   add_trace(app);
   add_configurations(app);
   try {
      app.parse(argc, argv);
      require_printed();
      return 0;
   } catch (const CLI::ParseError& error) {
      if (error.get_exit_code() == 0) return app.exit(error);  // --help, --version
      if (argc > 1 && app.get_subcommands().empty())
         return report(std::string(argv[1]) + ": there is no such command; see stereo_hls --help", kInputError);
      return report(std::string(error.what()) + "; see stereo_hls --help", kInputError);
   } catch (const InputError& error) {
      return report(error.what(), kInputError);
   } catch (const std::invalid_argument& error) {
      return report(error.what(), kInputError);
   } catch (const std::filesystem::filesystem_error& error) {  // a folder without rights, mostly
      return report(error.path1().string() + ": " + error.code().message(), kInputError);
   } catch (const std::exception& error) {
      return report(std::string("internal failure: ") + error.what(), kInternalError);
   }
}
