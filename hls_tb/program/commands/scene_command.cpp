// SPDX-License-Identifier: Apache-2.0
#include "program/commands/scene_command.hpp"

#include <CLI/CLI.hpp>
#include <sstream>
#include <utility>

#include "program/commands/checks.hpp"
#include "program/commands/frame_progress.hpp"
#include "program/commands/named_matching.hpp"
#include "program/io/images.hpp"
#include "program/io/output_folder.hpp"
#include "scene/scene.hpp"

namespace stereo::app {
namespace {

struct SceneArguments {
   std::string config, out;  ///< an empty config leaves the size to `options`
   SceneOptions options;
   int frames = 0;  ///< 0: one pair
};

/// What a scene has an image of, and its file.
const std::pair<const char*, const GrayImage& (*)(const Scene&)> kImages[] = {
    {"left", [](const Scene& scene) -> const GrayImage& { return scene.images.left; }},
    {"right", [](const Scene& scene) -> const GrayImage& { return scene.images.right; }},
    {"disparity_right", [](const Scene& scene) -> const GrayImage& { return scene.disparity; }},
    {"visible_right", [](const Scene& scene) -> const GrayImage& { return scene.visible; }},
    {"disparity_left", [](const Scene& scene) -> const GrayImage& { return scene.left_disparity; }},
    {"visible_left", [](const Scene& scene) -> const GrayImage& { return scene.left_visible; }},
};

void write_pair(const std::string& path, const SceneOptions& options) {
   const Scene made = make_scene(options);
   OutputFolder out(path);
   for (const auto& [name, image] : kImages) out.add(std::string(name) + ".png", encode_png(image(made)));
   out.commit();
}

/// A folder for each kind of image, as `video` takes them.
void write_frames(const std::string& path, SceneOptions options, int frames) {
   OutputFolder parent(path);
   std::vector<std::unique_ptr<OutputFolder>> folders;
   for (const auto& [name, image] : kImages) folders.push_back(std::make_unique<OutputFolder>(path + "/" + name));
   FrameProgress progress;
   for (options.frame = 0; options.frame < frames; ++options.frame) {
      const Scene made = make_scene(options);
      std::ostringstream file;
      file << std::setw(5) << std::setfill('0') << options.frame << ".png";
      for (std::size_t i = 0; i < folders.size(); ++i) folders[i]->add(file.str(), encode_png(kImages[i].second(made)));
      progress.frame_done();
   }
   std::cout << progress.line_start() << frames << " frames in " << path << '\n';
   for (const auto& folder : folders) folder->commit(OutputFolder::Says::nothing);
}

void scene(const SceneArguments& arguments) {
   SceneOptions options = arguments.options;
   if (!arguments.config.empty()) {
      const Configuration& configuration = require_configuration(arguments.config);
      options.width = configuration.shape.image.width_px;
      options.height = configuration.shape.image.height_px;
      options.disparities =
          std::min(configuration.algorithm->map_geometry(options.width).disparities, options.width - 1);
   }
   if (arguments.frames > 0) write_frames(arguments.out, options, arguments.frames);
   else write_pair(arguments.out, options);
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
   command->add_option("--frames", arguments.frames, "a moving scene: folders left, right ... of this many images")
       ->check(CLI::Range(1, 65536));
   command->callback([] { scene(arguments); });
}

}  // namespace stereo::app
