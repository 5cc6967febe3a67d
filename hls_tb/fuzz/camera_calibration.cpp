// SPDX-License-Identifier: Apache-2.0
#include "definition/gray_image.hpp"
#include "fuzz/targets.hpp"
#include "program/depth/calibration_formats.hpp"
#include "program/depth/rectification.hpp"
#include "program/errors.hpp"

namespace stereo::fuzz {
namespace {

constexpr std::string_view kRight = "\n=== right\n";  ///< between the files of both cameras
constexpr int kWidth = 48, kHeight = 32;

std::optional<app::Calibration> parsed(std::string_view bytes) {
   const std::size_t at = bytes.find(kRight);
   if (at == std::string_view::npos) return app::parse_calibration(std::string(bytes));
   return app::parse_calibrations({"it", std::string(bytes.substr(0, at))},
                                  {"it", std::string(bytes.substr(at + kRight.size()))});
}

/// What the commands do with it; they refuse what does not fit.
void use(const app::Calibration& calibration) {
   try {
      const app::RectifiedGeometry geometry = app::rectified_geometry(calibration);
      promise(geometry.focal_px() > 0 && geometry.baseline() > 0, "a geometry has a focal length and a baseline");
   } catch (const app::InputError& refusal) {
      check_refusal(refusal, "");
   }
   try {
      const app::Rectification made = app::make_rectification(calibration, kWidth, kHeight);
      promise(made.geometry.focal_px() > 0 && made.left_x.size() == cv::Size(kWidth, kHeight),
              "a rectification has maps and a geometry");
   } catch (const app::InputError& refusal) {
      check_refusal(refusal, "");
   }
}

}  // namespace

bool camera_calibration(std::string_view bytes) {
   std::optional<app::Calibration> calibration;
   try {
      calibration = parsed(bytes);
   } catch (const app::InputError& refusal) {
      check_refusal(refusal, "");
      return false;
   }
   if (!calibration) return false;
   promise(calibration->lens != app::Lens::ambiguous, "these formats say which lens it is");
   for (const cv::Mat* const camera : {&calibration->m1, &calibration->m2})
      promise(camera->empty() || camera->size() == cv::Size(3, 3), "a camera matrix is 3x3");
   promise(calibration->r.empty() == calibration->t.empty(), "a turn has a shift");
   use(*calibration);
   return true;
}

}  // namespace stereo::fuzz
