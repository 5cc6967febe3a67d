// SPDX-License-Identifier: Apache-2.0
#include "program/commands/video_command.hpp"

#include <CLI/CLI.hpp>
#include <iomanip>
#include <iostream>
#include <opencv2/imgproc.hpp>

#include "program/commands/checks.hpp"
#include "program/commands/frame_progress.hpp"
#include "program/commands/named_matching.hpp"
#include "program/commands/postprocessing_options.hpp"
#include "program/commands/threads_option.hpp"
#include "program/commands/timed.hpp"
#include "program/depth/pair_warnings.hpp"
#include "program/errors.hpp"
#include "program/io/opencv_images.hpp"
#include "program/video/frame_sink.hpp"
#include "program/video/frame_source.hpp"

namespace stereo::app {
namespace {

constexpr double kUsualRate = 25;  ///< frames a second, of a folder of images
const cv::Scalar kOutside(32, 32, 32);

struct Arguments {
   std::string left, right, side_by_side, config, out;
   std::vector<std::string> settings;
   double frames_per_second = 0;  ///< 0: the input's
   int threads = 1;
   Postprocessing postprocessing;
};

PairSource open_pair(const Arguments& arguments, int bits) {
   if (!arguments.side_by_side.empty()) return PairSource(open_frames("--side-by-side", arguments.side_by_side, bits));
   if (arguments.left.empty() || arguments.right.empty())
      throw InputError("video: give --left and --right, or --side-by-side");
   return open_cameras(arguments.left, arguments.right, bits);
}

cv::Mat in_color(const cv::Mat& frame) {
   cv::Mat color;
   if (frame.channels() == 3) return frame;
   cv::cvtColor(frame, color, frame.channels() == 1 ? cv::COLOR_GRAY2BGR : cv::COLOR_BGRA2BGR);
   return color;
}

/// The reference image, and beside it the map at the columns that it belongs to.
cv::Mat beside(const cv::Mat& reference, const DisparityMap& map, const MapGeometry& geometry) {
   const int width = reference.cols;
   cv::Mat page(reference.rows, 2 * width, CV_8UC3, kOutside);
   in_color(reference).copyTo(page.colRange(0, width));
   const int first = width + geometry.first_column;
   colored(map, geometry.disparities).copyTo(page.colRange(first, first + map.width));
   return page;
}

void video(const Arguments& arguments) {
   const auto algorithm = named_algorithm(arguments.config, arguments.settings);
   const int bits = algorithm->pixel_bits();
   PairSource source = open_pair(arguments, bits);
   const double own_rate = source.frames_per_second(), rate = arguments.frames_per_second > 0
                                                                  ? arguments.frames_per_second
                                                              : own_rate > 0 ? own_rate
                                                                             : kUsualRate;
   std::unique_ptr<FrameSink> sink;
   FrameProgress progress;
   double matching_seconds = 0;
   cv::Size size;
   for (FramePair frames = source.next(); !frames.empty(); frames = source.next()) {
      const AnyPair pair = gray_pair(frames.left, frames.right);
      double milliseconds = 0;
      const MapGeometry geometry = algorithm->map_geometry(frames.left.cols);
      const std::string warning = sink ? "" : pair_warning(shown_pair(pair, bits), geometry);
      std::cout << warning;
      const auto match_once = [&](const auto& images) {
         return match_named(arguments.config, images, *algorithm, arguments.threads);
      };
      const auto match = [&](const auto& images) {
         return match_and_process(match_once, images, geometry, arguments.postprocessing).map;
      };
      const DisparityMap map = timed(milliseconds, [&] { return std::visit(match, pair); });
      if (!sink && warning.empty()) std::cout << last_disparity_warning(map, geometry);
      matching_seconds += milliseconds / 1000;
      const cv::Mat& reference = geometry.reference == Reference::left ? frames.left : frames.right;
      const cv::Mat page = beside(shown_image(reference, bits), map, geometry);
      size = frames.left.size();
      if (!sink)
         sink = make_frame_sink(arguments.out, rate, page.size(),
                                {arguments.left, arguments.right, arguments.side_by_side});
      sink->add(page);
      progress.frame_done();
   }
   std::cout << progress.line_start() << progress.frames() << " frames of " << size_text(size) << ": " << std::fixed
             << std::setprecision(1) << progress.frames() / matching_seconds
             << " frames a second in the matching alone (threads: " << arguments.threads << "), "
             << progress.frames() / progress.seconds() << " overall\n";
   sink->commit();
}

}  // namespace

void add_video(CLI::App& app) {
   static Arguments arguments;
   CLI::App* command = app.add_subcommand("video", "disparity maps of a stereo video, in colour beside the input");
   CLI::Option* left = command->add_option("--left", arguments.left, "left camera: a video file or a folder of images");
   CLI::Option* right = command->add_option("--right", arguments.right, "right camera");
   command->add_option("--side-by-side", arguments.side_by_side, "both in one: a video file or a folder of images")
       ->excludes(left)
       ->excludes(right);
   command->add_option("--config", arguments.config, "configuration, run by the fast model on whole frames")
       ->required();
   command->add_option("--set", arguments.settings, "NAME=VALUE: override an option of the configuration")
       ->allow_extra_args(false);
   add_postprocessing_options(*command, arguments.postprocessing, "each map");
   add_threads_option(*command, arguments.threads);
   command
       ->add_option("--frames-per-second", arguments.frames_per_second,
                    "frame rate of the result; default: the input's, or 25")
       ->check(check_positive_number)
       ->check(CLI::Range(0.1, 1000.0));
   command->add_option("--out", arguments.out, "a video NAME.avi, or a folder for images")->required();
   command->callback([] { video(arguments); });
}

}  // namespace stereo::app
