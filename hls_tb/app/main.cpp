// SPDX-License-Identifier: Apache-2.0
#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <map>
#include <stdexcept>

#include "app/commands.hpp"
#include "app/depth_command.hpp"
#include "app/errors.hpp"
#include "app/evaluate_command.hpp"
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

/// An option whose words stand for values.
template <class Value>
void add_choice(CLI::App& command, const std::string& option, Value& value, const std::map<std::string, Value>& words,
                const std::string& help) {
   command
       .add_option_function<std::string>(
           option, [&value, &words](const std::string& word) { value = words.at(word); }, help)
       ->check(CLI::IsMember(&words));
}

void add_pair_options(CLI::App& command, std::string& left, std::string& right, Fit& fit) {
   static const std::map<std::string, Fit> kFits{{"none", Fit::none}, {"crop", Fit::crop}, {"resize", Fit::resize}};
   command.add_option("--left", left, "left image of the rectified pair")->required();
   command.add_option("--right", right, "right image")->required();
   add_choice(command, "--fit", fit, kFits,
              "images of another size than the configuration's: none (default), crop or resize");
}

void add_match(CLI::App& app) {
   static MatchArguments arguments;
   static const std::map<std::string, Engine> kEngines{{"fast", Engine::fast}, {"clocked", Engine::clocked}};
   CLI::App* command = app.add_subcommand("match", "make a disparity map: disparity.png, overview.png, match.json ...");
   command->add_option("--config", arguments.config, "configuration")->required();
   command->add_option("--out", arguments.out, "folder for the results")->required();
   add_choice(*command, "--engine", arguments.engine, kEngines,
              "fast (default): the software model, any size; clocked: the hardware's C++");
   add_pair_options(*command, arguments.left, arguments.right, arguments.fit);
   CLI::Option* truth =
       command->add_option("--truth", arguments.truth, "true disparities of the reference image: count bad pixels");
   truth->needs(command->add_option("--visible", arguments.visible, "pixels that count: not 0")->needs(truth));
   command->callback([] { match(arguments); });
}

void add_scene(CLI::App& app) {
   static SceneArguments arguments;
   stereo::SceneOptions& options = arguments.options;
   CLI::App* command = app.add_subcommand("scene", "make a stereo pair with ground truth: left.png, right.png, ...");
   command->add_option("--out", arguments.out, "folder for the results")->required();
   command->add_option("--seed", options.seed, "another number, another scene")
       ->required()
       ->check(CLI::NonNegativeNumber);
   CLI::Option* config = command->add_option("--config", arguments.config, "take the size from this configuration");
   command->add_option("--width", options.width, "image width")->capture_default_str()->excludes(config);
   command->add_option("--height", options.height, "image height")->capture_default_str()->excludes(config);
   command->add_option("--disparities", options.disparities, "disparity range")
       ->capture_default_str()
       ->excludes(config);
   command->add_option("--noise", options.noise, "sensor noise in grey levels")->capture_default_str();
   command->callback([] { scene(arguments); });
}

void add_vectors(CLI::App& app) {
   static VectorsArguments arguments;
   stereo::StimulusOptions& options = arguments.options;
   CLI::App* command = app.add_subcommand("vectors", "make test vectors for the hardware: stimulus.txt, expected.txt");
   command->add_option("--config", arguments.config, "configuration")->required();
   command->add_option("--out", arguments.out, "folder for the results")->required();
   command->add_option("--rows", arguments.rows, "send only image rows A:B, B excluded");
   command->add_option("--frames", options.frames, "frames back to back, odd ones upside down")
       ->check(CLI::Range(1, 1000))
       ->capture_default_str();
   command->add_option("--stall-percent", options.stall_percent, "chance of a bubble before a pixel pair")
       ->check(CLI::Range(0, 95))
       ->capture_default_str();
   command->add_option("--seed", options.seed, "of the bubbles and flush rows")
       ->capture_default_str()
       ->check(CLI::NonNegativeNumber);
   add_pair_options(*command, arguments.left, arguments.right, arguments.fit);
   command->callback([] { vectors(arguments); });
}

void add_trace(CLI::App& app) {
   static TraceArguments arguments;
   CLI::App* command = app.add_subcommand("trace", "trace all registers of the clocked core: trace.txt");
   command->add_option("--config", arguments.config, "configuration")->required();
   command->add_option("--out", arguments.out, "folder for the result")->required();
   command->add_option("--clocks", arguments.clocks, "length")->check(CLI::Range(10, 1000000))->capture_default_str();
   command->callback([] { trace(arguments); });
}

void add_configurations(CLI::App& app) {
   static bool as_json = false;
   CLI::App* command = app.add_subcommand("configurations", "list the hardware configurations");
   command->add_flag("--json", as_json, "as JSON, for scripts");
   command->callback([] { list_configurations(as_json); });
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
      if (!std::cout.flush()) throw std::runtime_error("the result cannot be written to standard output");
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
