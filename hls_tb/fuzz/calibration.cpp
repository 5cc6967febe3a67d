// SPDX-License-Identifier: Apache-2.0
#include "program/depth/calibration.hpp"

#include "fuzz/memory_file.hpp"
#include "fuzz/targets.hpp"
#include "program/depth/depth.hpp"
#include "program/depth/rectification.hpp"
#include "program/errors.hpp"
#include "program/rectification/map_table.hpp"

namespace stereo::fuzz {
namespace {

constexpr int kWidth = 64, kHeight = 48;
constexpr std::chrono::milliseconds kLimit{500};  ///< OpenCV does not come back from some files

void check(const app::RectifiedGeometry& geometry) {
   promise(geometry.focal_px() > 0 && geometry.baseline() > 0, "a geometry has a focal length and a baseline");
   constexpr int kRows = 2;
   app::DisparityImage map(kWidth, kRows);
   for (int x = 0; x < kWidth; ++x) map.at(x, 0) = float(x - 8);
   for (const Reference side : {Reference::left, Reference::right})
      for (const double metres_per_unit : {1.0, 1e-3}) {
         const std::vector<app::Point> points = app::points_of(map, side, geometry, metres_per_unit);
         promise(points.size() == map.px.size(), "each pixel has a point");
         for (const app::Point& point : points)
            promise(std::isfinite(point.x_m) && std::isfinite(point.y_m) && std::isfinite(point.z_m),
                    "a point stands somewhere");
         const cv::Mat colors(kRows, kWidth, CV_8UC1, cv::Scalar(0));
         promise(app::depth_image(points, kWidth, kRows).total() == points.size(), "each pixel has a depth");
         promise(!app::encode_ply(points, colors, app::axes_of(geometry)).empty(), "points can be written");
      }
}

/// A table that can be made leads to an image of the same size, and with the rows that it needs nothing is left out.
void check_table(const cv::Mat& map_x, const cv::Mat& map_y) {
   rectification::Warp warp;
   warp.rows_above = warp.rows_below = kHeight;
   const rectification::Table table = app::table_of({map_x, map_y, {kWidth, kHeight}}, warp, "left camera");
   const GrayImage source(kWidth, kHeight, 200);
   const GrayImage whole = rectification::rectified(source, table, warp);
   const rectification::RowsNeeded needed = rectification::rows_needed(table, warp, kWidth, kHeight);
   warp.rows_above = needed.above;
   warp.rows_below = needed.below;
   promise(rectification::rectified(source, table, warp) == whole, "the rows that a table needs are enough");
}

/// Runs what may refuse a calibration; whether it did not.
template <class Use>
bool taken_by(Use use) {
   try {
      use();
      return true;
   } catch (const app::InputError& refusal) {
      check_refusal(refusal, "");
      return false;
   }
}

}  // namespace

bool calibration(std::string_view bytes) {
   const MemoryFile file(bytes);
   app::Calibration calibration;
   try {
      calibration = app::load_calibration({file.path(), "", file.path(), false}, kLimit);
   } catch (const app::InputError& refusal) {
      check_refusal(refusal, file.path() + ": ");
      return false;
   }
   const bool rectified = taken_by([&] { check(app::rectified_geometry(calibration)); });
   const bool rectifiable = taken_by([&] {
      const app::Rectification made = app::make_rectification(calibration, kWidth, kHeight);
      check(made.geometry);
      const cv::Mat image(kHeight, kWidth, CV_8UC3, cv::Scalar::all(7));
      promise(made.left(image).size() == image.size() && made.right(image).size() == image.size(),
              "a rectified image has the size of the camera's");
   });
   const bool has_table = taken_by([&] {
      const app::Rectification made =
          app::make_rectification(calibration, kWidth, kHeight, rectification::Warp().grid_px);
      check_table(made.left_x, made.left_y);
      check_table(made.right_x, made.right_y);
   });
   return rectified || rectifiable || has_table;
}

}  // namespace stereo::fuzz
