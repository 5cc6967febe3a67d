// SPDX-License-Identifier: Apache-2.0
#include "program/commands/scene_command.hpp"

#include <CLI/CLI.hpp>

#include "program/commands/checks.hpp"
#include "program/commands/named_matching.hpp"
#include "program/io/images.hpp"
#include "program/io/output_folder.hpp"
#include "scene/scene.hpp"

namespace stereo::app {
namespace {

struct SceneArguments {
   std::string config, out;  ///< an empty config leaves the size to `options`
   SceneOptions options;
};

void scene(const SceneArguments& arguments) {
   SceneOptions options = arguments.options;
   if (!arguments.config.empty()) {
      const Configuration& configuration = require_configuration(arguments.config);
      options.width = configuration.shape.image.width_px;
      options.height = configuration.shape.image.height_px;
      options.disparities =
          std::min(configuration.algorithm->map_geometry(options.width).disparities, options.width - 1);
   }
   const Scene made = make_scene(options);
   OutputFolder out(arguments.out);
   out.add("left.png", encode_png(made.images.left));
   out.add("right.png", encode_png(made.images.right));
   out.add("disparity_right.png", encode_png(made.disparity));
   out.add("visible_right.png", encode_png(made.visible));
   out.add("disparity_left.png", encode_png(made.left_disparity));
   out.add("visible_left.png", encode_png(made.left_visible));
   out.commit();
}

}  // namespace

void add_scene(CLI::App& app) {
   static SceneArguments arguments;
   SceneOptions& options = arguments.options;
   CLI::App* command = app.add_subcommand("scene", "make a stereo pair with ground truth: left.png, right.png, ...");
   command->add_option("--out", arguments.out, "folder for the results")->required();
   command->add_option("--seed", options.seed, "another number, another scene")->required()->check(check_seed);
   CLI::Option* config = command->add_option("--config", arguments.config, "take the size from this configuration");
   command->add_option("--width", options.width, "image width")->capture_default_str()->excludes(config);
   command->add_option("--height", options.height, "image height")->capture_default_str()->excludes(config);
   command->add_option("--disparities", options.disparities, "disparity range")
       ->capture_default_str()
       ->excludes(config);
   command->add_option("--noise", options.noise, "sensor noise in grey levels")->capture_default_str();
   command->callback([] { scene(arguments); });
}

}  // namespace stereo::app
