// SPDX-License-Identifier: Apache-2.0
#include "program/commands/rectify_command.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iomanip>
#include <iostream>
#include <optional>
#include <sstream>

#include "program/commands/calibration_options.hpp"
#include "program/commands/options_json.hpp"
#include "program/depth/rectification.hpp"
#include "program/errors.hpp"
#include "program/io/images.hpp"
#include "program/io/output_folder.hpp"
#include "program/rectification/map_table.hpp"
#include "rectification/config.hpp"

namespace stereo::app {
namespace {

using rectification::Config;
using rectification::RowsNeeded;
using rectification::Table;

struct Arguments {
   CalibrationOptions calibration;
   std::string left, right, out;
   int width = 0, height = 0;
   std::vector<std::string> settings;
};

struct Camera {
   std::string name;  ///< "left" or "right"
   RemapMaps maps;
   Table table;
   RowsNeeded needed;
   std::optional<Difference> grey = std::nullopt;
};

/// Options: Config, or the part of it that does not know the images.
template <class Options = Config>
void require_possible(const Options& options) {
   if (const Sentence problem = options.problem(); !problem.empty())
      throw InputError(std::string("no core can rectify this: ") + problem.text);
}

/// A configuration with the options of --set, and which rows are among them.
struct Wished {
   Config config;
   bool rows_above = false, rows_below = false;
};

Wished wished(const std::vector<std::string>& settings) {
   Wished made{{{}, {.rows_above = 0, .rows_below = 0}}};
   for_each_setting(settings, [&made](const std::string& name, const std::string& value) {
      set_option<rectification::Warp>(made.config, name, value);
      made.rows_above = made.rows_above || name == "rows_above";
      made.rows_below = made.rows_below || name == "rows_below";
   });
   require_possible<rectification::Warp>(made.config);
   return made;
}

/// As many as needed, or more where --set says so.
void settle_rows(int& rows, bool set, const char* option, int needed) {
   if (!set) rows = needed;
   if (rows < needed)
      throw InputError("--set " + std::string(option) + "=" + std::to_string(rows) + ": this calibration needs " +
                       std::to_string(needed));
}

Camera camera_of(const std::string& name, const RemapMaps& maps, const Config& config) {
   Camera camera{name, maps, table_of(maps, config, name + " camera"), {}};
   camera.needed = rows_needed(camera.table, config, config.width_px, config.height_px);
   return camera;
}

/// A node a line, row by row: hexadecimal, the offset to the right in the lower half, the one down in the upper half.
std::string table_text(const Table& table, int offset_bits) {
   std::ostringstream text;
   text << std::hex << std::setfill('0');
   const uint32_t mask = (1U << offset_bits) - 1;
   for (const rectification::Offset& node : table.nodes)
      text << std::setw((2 * offset_bits + 3) / 4)
           << ((uint32_t(node.y) & mask) << offset_bits | (uint32_t(node.x) & mask)) << '\n';
   return text.str();
}

int buffer_bits(const Config& config) { return config.buffered_columns() * config.buffered_rows() * config.pixel_bits; }

std::string summary(const Config& config, const std::vector<Camera>& cameras) {
   std::ostringstream text;
   text << "table: " << config.table_columns() << "x" << config.table_rows() << " nodes of 2 x " << config.offset_bits
        << " bits, " << config.table_bits(config.width_px, config.height_px) << " bits a camera\n"
        << "rows: " << config.rows_above << " above and " << config.rows_below << " below a pixel's own, so "
        << config.buffered_rows() << " buffered, " << buffer_bits(config) << " bits a camera; a row leaves "
        << config.lag_rows() << " rows after it came in\n";
   for (const Camera& camera : cameras) {
      const Difference place = place_difference(camera.table, config, camera.maps);
      text << camera.name << ": needs " << camera.needed.above << " rows above and " << camera.needed.below
           << " below; from the float maps at most " << place.largest << " px, mean " << place.mean << " px";
      if (camera.grey)
         text << "; from cv::remap at most " << camera.grey->largest << " grey levels, mean " << camera.grey->mean;
      text << "\n";
   }
   return text.str();
}

nlohmann::json facts(const Arguments& arguments, const Config& config, const std::vector<Camera>& cameras) {
   nlohmann::json json = {{"format", "stereo-hls rectify 1"},
                          {"calibration", arguments.calibration.files.path},
                          {"parameters", options_json(option_values(config))},
                          {"table_columns", config.table_columns()},
                          {"table_rows", config.table_rows()},
                          {"table_bits", config.table_bits(config.width_px, config.height_px)},
                          {"buffered_rows", config.buffered_rows()},
                          {"buffer_bits", buffer_bits(config)},
                          {"lag_rows", config.lag_rows()}};
   for (const Camera& camera : cameras) {
      const Difference place = place_difference(camera.table, config, camera.maps);
      nlohmann::json& of_camera = json[camera.name];
      of_camera = {{"rows_above", camera.needed.above},
                   {"rows_below", camera.needed.below},
                   {"largest_place_difference_px", place.largest},
                   {"mean_place_difference_px", place.mean}};
      if (!camera.grey) continue;
      of_camera["largest_grey_difference"] = camera.grey->largest;
      of_camera["mean_grey_difference"] = camera.grey->mean;
   }
   return json;
}

void rectify(const Arguments& arguments) {
   const bool sized = arguments.width != 0 || arguments.height != 0;
   if (arguments.left.empty() != sized)
      throw InputError("give --left and --right, or --width and --height without images");
   const Calibration loaded = load_calibration(arguments.calibration.files);
   const Wished wish = wished(arguments.settings);
   Config config = wish.config;
   const AnyPair pair = sized ? ImagePair() : load_any_pair(arguments.left, arguments.right, config.pixel_bits);
   const auto size_of = [](const auto& images) { return cv::Size(images.left.width, images.left.height); };
   const cv::Size size = sized ? cv::Size(arguments.width, arguments.height) : std::visit(size_of, pair);
   config.width_px = size.width;
   config.height_px = size.height;
   require_possible(config);
   const Calibration calibration = fitted_calibration(loaded, size, arguments.calibration.size());
   const Rectification maps = make_rectification(calibration, config.width_px, config.height_px, config.grid_px);
   std::cout << maps.warnings;
   std::vector<Camera> cameras = {camera_of("left", {maps.left_x, maps.left_y, size}, config),
                                  camera_of("right", {maps.right_x, maps.right_y, size}, config)};
   settle_rows(config.rows_above, wish.rows_above, "rows_above",
               std::max(cameras[0].needed.above, cameras[1].needed.above));
   settle_rows(config.rows_below, wish.rows_below, "rows_below",
               std::max(cameras[0].needed.below, cameras[1].needed.below));
   require_possible(config);

   OutputFolder out(arguments.out, arguments.calibration.with({arguments.left, arguments.right}));
   for (Camera& camera : cameras) {
      out.add(camera.name + "_table.hex", table_text(camera.table, config.offset_bits));
      if (sized) continue;
      const auto add_image = [&](const auto& images) {
         const auto& source = camera.name == "left" ? images.left : images.right;
         const auto made = rectified(source, camera.table, config);
         camera.grey = grey_difference(made, source, camera.maps);
         out.add(camera.name + ".png", encode_png(made));
      };
      std::visit(add_image, pair);
   }
   out.add_facts("rectify.json", facts(arguments, config, cameras));
   std::cout << summary(config, cameras);
   out.commit();
}

}  // namespace

void add_rectify(CLI::App& app) {
   static Arguments arguments;
   CLI::App* command = app.add_subcommand("rectify",
                                          "make the tables of the hardware rectification, and rectify images with its "
                                          "integers: left_table.hex, left.png ...");
   add_calibration_options(*command, arguments.calibration);
   CLI::Option* left = command->add_option("--left", arguments.left, "left camera's image");
   CLI::Option* right = command->add_option("--right", arguments.right, "right camera's image");
   CLI::Option* width = command->add_option("--width", arguments.width, "image width, where there are no images");
   CLI::Option* height = command->add_option("--height", arguments.height, "image height");
   left->needs(right);
   right->needs(left);
   width->needs(height);
   height->needs(width);
   command
       ->add_option("--set", arguments.settings,
                    "NAME=VALUE: set an option, such as grid_px=8; rows_above and rows_below default to what the "
                    "calibration needs")
       ->allow_extra_args(false);
   command->add_option("--out", arguments.out, "folder for the results")->required();
   command->callback([] { rectify(arguments); });
}

}  // namespace stereo::app
