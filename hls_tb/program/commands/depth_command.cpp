// SPDX-License-Identifier: Apache-2.0
#include "program/commands/depth_command.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <limits>
#include <map>
#include <optional>
#include <sstream>

#include "program/commands/calibration_options.hpp"
#include "program/commands/checks.hpp"
#include "program/commands/named_matching.hpp"
#include "program/commands/options_json.hpp"
#include "program/commands/pair_options.hpp"
#include "program/commands/postprocessing_options.hpp"
#include "program/commands/threads_option.hpp"
#include "program/commands/timed.hpp"
#include "program/depth/depth.hpp"
#include "program/depth/pair_warnings.hpp"
#include "program/depth/rectification.hpp"
#include "program/errors.hpp"
#include "program/io/images.hpp"
#include "program/io/opencv_images.hpp"
#include "program/io/output_folder.hpp"
#include "program/io/overview.hpp"

namespace stereo::app {
namespace {

constexpr double kMetre = 1000;  ///< millimetres

struct Arguments {
   CalibrationOptions calibration;
   std::string left, right, config, out;
   std::vector<std::string> settings;
   std::optional<double> unit_mm;
   PlyFormat ply = PlyFormat::binary;
   bool tiff = false;
   bool rectified = false;
   int threads = 1;
   Postprocessing postprocessing;
   std::optional<double> least_mm, largest_mm;  ///< of the depths that are kept
};

/// A pair that can be matched, in colour where the cameras' images are, and where it stands.
struct PreparedPair {
   cv::Mat left, right;  ///< as `read_camera_image` gives them
   int bits;             ///< that it was told
   double unit_mm;       ///< of the geometry
   RectifiedGeometry geometry;

   AnyPair gray() const { return gray_pair(left, right); }
   ImagePair shown() const { return shown_pair(gray(), bits); }
};

PreparedPair prepare(const Arguments& arguments, int bits) {
   Calibration loaded = load_calibration(arguments.calibration.files);
   if (!arguments.unit_mm && !loaded.unknown_unit.empty())
      throw InputError("--calibration: " + loaded.unknown_unit + ": give its length in millimetres with --unit-mm");
   const double unit_mm = arguments.unit_mm.value_or(loaded.unit_mm > 0 ? loaded.unit_mm : kMetre);
   if (arguments.rectified && !loaded.rectified_size.empty()) loaded.image_size = loaded.rectified_size;
   PreparedPair pair{
       read_camera_image(arguments.left, bits), read_camera_image(arguments.right, bits), bits, unit_mm, {}};
   require_same_size<InputError>(arguments.left, pair.left.size(), arguments.right, pair.right.size());
   const cv::Size size = pair.left.size(), given = arguments.calibration.size();
   const Calibration calibration = fitted_calibration(loaded, size, given);
   if (arguments.rectified) {
      pair.geometry = rectified_geometry(calibration);
      const bool known = !given.empty() || !calibration.image_size.empty();
      std::cout << checked_principal_point(pair.geometry, size, known);
      return pair;
   }
   const Rectification rectification = make_rectification(calibration, size.width, size.height);
   std::cout << rectification.warnings;
   if (const auto offset = vertical_offset(matched_features(pair.shown())))
      std::cout << "before rectification " << offset->features << " matching features lie " << offset->median_px
                << " rows apart (median)\n";
   return {rectification.left(pair.left), rectification.right(pair.right), bits, unit_mm, rectification.geometry};
}

struct Depths {
   int known = 0;
   int nearest_mm = 0, farthest_mm = 0;  ///< of the known ones
};

Depths depths_of(const cv::Mat_<uint16_t>& image) {
   Depths depths;
   for (const int mm : image) {
      if (mm == 0) continue;
      depths.nearest_mm = depths.known == 0 ? mm : std::min(depths.nearest_mm, mm);
      depths.farthest_mm = std::max(depths.farthest_mm, mm);
      ++depths.known;
   }
   return depths;
}

nlohmann::json facts(const Arguments& arguments, const PreparedPair& pair, const Algorithm& algorithm,
                     const Depths& depths, int left_out, double milliseconds) {
   const auto limit = [](const std::optional<double>& mm) { return mm ? nlohmann::json(*mm) : nlohmann::json(); };
   return {{"format", "stereo-hls depth 1"},
           {"config", arguments.config},
           {"parameters", options_json(algorithm.options())},
           {"left", arguments.left},
           {"right", arguments.right},
           {"calibration", arguments.calibration.files.path},
           {"rectified_before", arguments.rectified},
           {"width_px", pair.left.cols},
           {"height_px", pair.left.rows},
           {"focal_px", pair.geometry.focal_px()},
           {"baseline_mm", pair.geometry.baseline() * pair.unit_mm},
           {"depth_unit", "mm"},
           {"depth_png_mm_per_value", 1},
           {"known_px", depths.known},
           {"postprocessing", postprocessing_json(arguments.postprocessing)},
           {"least_depth_mm", limit(arguments.least_mm)},
           {"largest_depth_mm", limit(arguments.largest_mm)},
           {"left_out_px", left_out},
           {"nearest_mm", depths.nearest_mm},
           {"farthest_mm", depths.farthest_mm},
           {"threads", arguments.threads},
           {"milliseconds", milliseconds}};
}

/// A sentence where the baseline is that of no two cameras, as with T in another unit, or where all depths are too
/// large; else nothing. `points`: of the cloud.
std::string unit_hint(double baseline_mm, double unit_mm, int points, int known) {
   constexpr double kShortest = 0.5, kLongest = 5000;  // mm
   std::ostringstream text;
   if (baseline_mm < kShortest || baseline_mm > kLongest)
      text << "warning: a baseline of " << baseline_mm << " mm: is T in "
           << (baseline_mm > kLongest ? "millimetres? Then give --unit-mm 1" : "metres? Then give --unit-mm 1000")
           << "\n";
   else if (points > 0 && known == 0)
      text << "warning: all " << points << " points are farther than " << kLargestDepthMm
           << " mm, which depth.png cannot hold: is the unit of T " << unit_mm << " mm, as --unit-mm says?\n";
   return text.str();
}

std::string summary(const PreparedPair& pair, double baseline_mm, const Depths& depths) {
   std::ostringstream text;
   text << "focal length " << pair.geometry.focal_px() << " px, baseline " << baseline_mm << " mm: depth of "
        << depths.known << " of " << pair.left.total() << " pixels";
   if (depths.known > 0) text << ", " << depths.nearest_mm << " ... " << depths.farthest_mm << " mm";
   text << "\n";
   return text.str();
}

void depth(const Arguments& arguments) {
   if (arguments.least_mm && arguments.largest_mm && *arguments.least_mm > *arguments.largest_mm)
      throw InputError("--least-depth-mm: is above --largest-depth-mm");
   const auto algorithm = named_algorithm(arguments.config, arguments.settings);
   const PreparedPair pair = prepare(arguments, algorithm->pixel_bits());
   const AnyPair gray = pair.gray();
   const ImagePair shown = shown_pair(gray, pair.bits);
   const MapGeometry map_geometry = algorithm->map_geometry(shown.left.width);
   const std::string warning = pair_warning(shown, map_geometry);
   std::cout << warning;
   double milliseconds = 0;
   const auto match_once = [&](const auto& images) {
      return match_named(arguments.config, images, *algorithm, arguments.threads);
   };
   const auto match = [&](const auto& images) {
      return match_and_process(match_once, images, map_geometry, arguments.postprocessing).map;
   };
   const DisparityMap map = timed(milliseconds, [&] { return std::visit(match, gray); });
   if (warning.empty()) std::cout << last_disparity_warning(map, map_geometry);
   std::vector<Point> points = points_of(at_image_size(map, map_geometry, shown.left.width), map_geometry.reference,
                                         pair.geometry, pair.unit_mm / kMetre);
   const int left_out = keep_depths(points, arguments.least_mm.value_or(0) / kMetre,
                                    arguments.largest_mm.value_or(std::numeric_limits<double>::infinity()) / kMetre);
   const cv::Mat image = depth_image(points, shown.left.width, shown.left.height);
   const Depths depths = depths_of(image);
   const cv::Mat& reference = map_geometry.reference == Reference::left ? pair.left : pair.right;

   OutputFolder out(arguments.out, arguments.calibration.with({arguments.left, arguments.right}));
   out.add("depth.png", encode(image));
   if (arguments.tiff)
      out.add("depth.tiff", encode_tiff(float_depth_image(points, shown.left.width, shown.left.height)));
   out.add("cloud.ply", encode_ply(points, shown_image(reference, pair.bits), axes_of(pair.geometry), arguments.ply));
   out.add("preview.png", encode_overview_png(shown, map, map_geometry));
   if (!arguments.rectified) {
      out.add("left.png", encode(pair.left));
      out.add("right.png", encode(pair.right));
   }
   out.add_facts("depth.json", facts(arguments, pair, *algorithm, depths, left_out, milliseconds));
   const auto known = std::count_if(points.begin(), points.end(), [](const Point& point) { return point.z_m != 0; });
   std::cout << unit_hint(pair.geometry.baseline() * pair.unit_mm, pair.unit_mm, int(known), depths.known);
   std::cout << summary(pair, pair.geometry.baseline() * pair.unit_mm, depths);
   out.commit();
}

}  // namespace

void add_depth(CLI::App& app) {
   static Arguments arguments;
   CLI::App* command =
       app.add_subcommand("depth", "depth in millimetres and a point cloud in metres: depth.png, cloud.ply ...");
   add_calibration_options(*command, arguments.calibration);
   command->add_option("--left", arguments.left, "left camera's image")->required();
   command->add_option("--right", arguments.right, "right camera's image")->required();
   command->add_option("--config", arguments.config, "configuration, run by the fast model on the whole images")
       ->required();
   command->add_option("--set", arguments.settings, "NAME=VALUE: override an option of the configuration")
       ->allow_extra_args(false);
   command
       ->add_option(
           "--unit-mm", arguments.unit_mm,
           "length of one unit of the calibration's T in millimetres; default: that of its format, else 1000 (metres)")
       ->check(check_positive_number);
   add_threads_option(*command, arguments.threads);
   add_postprocessing_options(*command, arguments.postprocessing, "the depths");
   command
       ->add_option("--least-depth-mm", arguments.least_mm,
                    "mark nearer pixels as unknown, in all files but preview.png")
       ->check(check_positive_number);
   command
       ->add_option("--largest-depth-mm", arguments.largest_mm,
                    "mark farther pixels as unknown, in all files but preview.png")
       ->check(check_positive_number);
   static const std::map<std::string, PlyFormat> kPlyFormats{{"binary", PlyFormat::binary},
                                                             {"ascii", PlyFormat::ascii}};
   add_choice(*command, "--ply", arguments.ply, kPlyFormats, "cloud.ply as binary (default), little endian, or ascii");
   command->add_flag("--tiff", arguments.tiff, "also write depth.tiff: millimetres as 32-bit floats, 0: unknown");
   command->add_flag("--rectified", arguments.rectified, "the images are rectified already");
   command->add_option("--out", arguments.out, "folder for the results")->required();
   command->callback([] { depth(arguments); });
}

}  // namespace stereo::app
