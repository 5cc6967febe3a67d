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
   int frames = 0;      ///< 0: one pair
   int pixel_bits = 8;  ///< of left and right
};

/// What a scene has an image of besides the pair, and its file.
const std::pair<const char*, const GrayImage& (*)(const Scene&)> kImages[] = {
    {"disparity_right", [](const Scene& scene) -> const GrayImage& { return scene.disparity; }},
    {"visible_right", [](const Scene& scene) -> const GrayImage& { return scene.visible; }},
    {"disparity_left", [](const Scene& scene) -> const GrayImage& { return scene.left_disparity; }},
    {"visible_left", [](const Scene& scene) -> const GrayImage& { return scene.left_visible; }},
};

struct NamedPng {
   std::string name, bytes;
};

std::vector<NamedPng> images_of(const SceneOptions& options, int pixel_bits) {
   const Scene made = make_scene(options);
   std::vector<NamedPng> files;
   const auto add_pair = [&files](const auto& pair) {
      files.push_back({"left", encode_png(pair.left)});
      files.push_back({"right", encode_png(pair.right)});
   };
   if (pixel_bits > 8) add_pair(deepened(made.images, pixel_bits, options.seed + uint64_t(options.frame)));
   else add_pair(made.images);
   for (const auto& [name, image] : kImages) files.push_back({name, encode_png(image(made))});
   return files;
}

void write_pair(const std::string& path, const SceneOptions& options, int pixel_bits) {
   std::vector<NamedPng> images = images_of(options, pixel_bits);
   OutputFolder out(path);
   for (NamedPng& file : images) out.add(file.name + ".png", std::move(file.bytes));
   out.commit();
}

/// A folder for each kind of image, as `video` takes them.
void write_frames(const std::string& path, SceneOptions options, int frames, int pixel_bits) {
   OutputFolder parent(path);
   std::vector<std::unique_ptr<OutputFolder>> folders;
   FrameProgress progress;
   for (options.frame = 0; options.frame < frames; ++options.frame) {
      std::vector<NamedPng> images = images_of(options, pixel_bits);
      if (folders.empty())
         for (const NamedPng& image : images)
            folders.push_back(std::make_unique<OutputFolder>(path + "/" + image.name));
      std::ostringstream file;
      file << std::setw(5) << std::setfill('0') << options.frame << ".png";
      for (std::size_t i = 0; i < folders.size(); ++i) folders[i]->add(file.str(), std::move(images[i].bytes));
      progress.frame_done();
   }
   std::cout << progress.line_start() << frames << " frames in " << path << '\n';
   for (const auto& folder : folders) folder->commit(OutputFolder::Says::nothing);
}

void scene(const SceneArguments& arguments) {
   SceneOptions options = arguments.options;
   int pixel_bits = arguments.pixel_bits;
   if (!arguments.config.empty()) {
      const Configuration& configuration = require_configuration(arguments.config);
      options.width = configuration.shape.image.width_px;
      options.height = configuration.shape.image.height_px;
      options.disparities =
          std::min(configuration.algorithm->map_geometry(options.width).disparities, options.width - 1);
      pixel_bits = configuration.algorithm->pixel_bits();
   }
   if (arguments.frames > 0) write_frames(arguments.out, options, arguments.frames, pixel_bits);
   else write_pair(arguments.out, options, pixel_bits);
}

}  // namespace

void add_scene(CLI::App& app) {
   static SceneArguments arguments;
   SceneOptions& options = arguments.options;
   CLI::App* command = app.add_subcommand("scene", "make a stereo pair with ground truth: left.png, right.png, ...");
   command->add_option("--out", arguments.out, "folder for the results")->required();
   command->add_option("--seed", options.seed, "another number, another scene")->required()->check(check_seed);
   CLI::Option* config =
       command->add_option("--config", arguments.config, "take the size and the pixels from this configuration");
   command->add_option("--width", options.width, "image width")->capture_default_str()->excludes(config);
   command->add_option("--height", options.height, "image height")->capture_default_str()->excludes(config);
   command->add_option("--disparities", options.disparities, "disparity range")
       ->capture_default_str()
       ->excludes(config);
   command->add_option("--pixel-bits", arguments.pixel_bits, "bits of a pixel in left and right: 8, 10 or 12")
       ->check(CLI::IsMember({8, 10, 12}))
       ->capture_default_str()
       ->excludes(config);
   command->add_option("--noise", options.noise, "sensor noise in grey levels")->capture_default_str();
   command->add_option("--frames", arguments.frames, "a moving scene: folders left, right ... of this many images")
       ->check(CLI::Range(1, 65536));
   command->callback([] { scene(arguments); });
}

}  // namespace stereo::app
