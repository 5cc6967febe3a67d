// SPDX-License-Identifier: Apache-2.0
// Damaged calibrations of ROS, Kalibr and MATLAB are refused, with the reason.
#include <gtest/gtest.h>

#include <opencv2/calib3d.hpp>

#include "program/depth/rectification.hpp"
#include "program/errors.hpp"
#include "testing/written_calibrations.hpp"

namespace stereo::app {
namespace {

using namespace test;

std::string sentence(const Written& written) {
   try {
      load_written(written);
   } catch (const InputError& problem) {
      return problem.what();
   }
   return "taken";
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
   const std::size_t at = text.find(from);
   if (at == std::string::npos) throw std::logic_error("the text has no " + from);
   return text.replace(at, from.size(), to);
}

/// What is wrong, and words of the sentence.
struct Damage {
   std::string from, to, says;
};

void expect_refusals(const std::vector<Damage>& damages, const std::function<Written(const Damage&)>& damaged) {
   for (const Damage& damage : damages) {
      const std::string found = sentence(damaged(damage));
      EXPECT_NE(found.find(damage.says), std::string::npos) << damage.from << " -> " << damage.to << ": " << found;
      EXPECT_EQ(found.find('\n'), std::string::npos) << found;
   }
}

TEST(RosCalibration, DamagedOnesAreRefused) {
   const Pair pair = simple_pair();
   const std::string left = ros_file(pair, true), right = ros_file(pair, false);
   expect_refusals(
       {{"image_width: 320", "image_width: 640", "images of 320x240 and 640x240"},
        {"image_width: 320\n", "", "it has no image_width"},
        {"image_width: 320", "image_width: 0", "image_width is not a number of pixels"},
        {"image_width: 320", "image_width: 1e9", "image_width is not a number of pixels"},
        {"plumb_bob", "equidistant", "has 5 coefficients"},
        {"plumb_bob", "kannala", "distortion_model is kannala"},
        {"distortion_model: plumb_bob\n", "", "no distortion_model"},
        {"[-0.25, 0.5, 0, 0, 0]", "[-0.25, 0.5, 0]", "has 3 coefficients"},
        {"[200, 0, 160, 0, 201, 120, 0, 0, 1]", "[200, 0, 0, 0, 201, 0, 160, 120, 1]",
         "its camera_matrix is not a camera matrix"},
        {"[200, 0, 160, 0, 201, 120, 0, 0, 1]", "[0, 0, 0, 0, 0, 0, 0, 0, 0]", "was not calibrated"},
        {"[200, 0, 160, 0, 201, 120, 0, 0, 1]", "[200, 0, 160, 0, 201, 120, 0, 0]", "camera_matrix is not 3x3 numbers"},
        {"[200, 0, 160, 0, 201, 120, 0, 0, 1]", "[200, 0, 160, 0, .nan, 120, 0, 0, 1]",
         "camera_matrix is not a list of numbers"},
        {"[1, 0, 0, 0, 1, 0, 0, 0, 1]", "[2, 0, 0, 0, 1, 0, 0, 0, 1]", "rectification_matrix is not a rotation"},
        {"[190, 0, 160, -19, 0, 190, 120, 0, 0, 0, 1, 0]", "[190, 0, 0, 0, 190, 0, 160, 120, 1, -19, 0, 0]",
         "its projection_matrix is not a camera matrix"},
        {"-19", "0", "no baseline"},
        {"-19", "19", "exchange the files"},
        {"[190, 0, 160, -19, 0, 190", "[290, 0, 160, -19, 0, 290", "not of one calibration"},
        {"120, 0, 0, 0, 1, 0]", "150, 0, 0, 0, 1, 0]", "not of one calibration"},
        {"rows: 3\n  cols: 4", "rows: 4\n  cols: 3", "projection_matrix is not 3x4 numbers"},
        {"image_width", "\timage_width", "is no camera_info of ROS"},
        {"camera_name", "binning_x: 2\ncamera_name", "binned"},
        {"camera_name", "roi: {x_offset: 8, y_offset: 0, width: 100, height: 100}\ncamera_name", "binned or a part"},
        {"camera_name", "image_width: 320\ncamera_name", "is no camera_info of ROS"}},
       [&](const Damage& damage) {
          return Written{left, replaced(right, damage.from, damage.to)};
       });
   EXPECT_NE(sentence({right, left}).find("exchange the files"), std::string::npos);
   EXPECT_NE(sentence({left, left}).find("no baseline"), std::string::npos);
   EXPECT_NE(sentence({left, ""}).find("--right-calibration"), std::string::npos);
   EXPECT_NE(sentence({kalibr(pair), right}).find("is no camera_info of ROS"), std::string::npos);
   EXPECT_NE(sentence({left, right, true}).find("of another model"), std::string::npos);
   EXPECT_NE(sentence({left + "---\n" + left, right}).find("is no camera_info of ROS"), std::string::npos)
       << "two documents";
   const std::string both = ros_both(pair);
   EXPECT_EQ(sentence({both, ""}), "taken");
   EXPECT_NE(sentence({replaced(both, "plumb_bob", "fov"), ""}).find("of its left camera, its distortion_model is fov"),
             std::string::npos);
   const std::string none =
       replaced(replaced(left, "rows: 1\n  cols: 5\n  data: [-0.25, 0.5, 0, 0, 0]", "rows: 1\n  cols: 0\n  data: []"),
                "plumb_bob", "\"\"");
   EXPECT_TRUE(load_written({none, right}).d1.empty());
}

TEST(RosCalibration, CamerasThatTurnAndStandOtherwise) {
   Pair pair = simple_pair();
   pair.p2 = (cv::Mat_<double>(3, 4) << 190, 0, 160, 0, 0, 190, 120, -19, 0, 0, 1, 0);
   const Calibration upright = load_written({ros_file(pair, true), ros_file(pair, false)});
   EXPECT_THROW(make_rectification(upright, kCameraSize.width, kCameraSize.height), InputError);
   EXPECT_THROW(rectified_geometry(upright), InputError);
}

TEST(KalibrCalibration, DamagedOnesAreRefused) {
   const std::string whole = kalibr(simple_pair()), both = kalibr(simple_pair(), Chain::both);
   expect_refusals({{"camera_model: pinhole", "camera_model: omni", "of cam0, its camera_model is omni"},
                    {"camera_model: pinhole\n", "\n", "camera_model is missing"},
                    {"radtan", "fov", "of cam0, its distortion_model is fov"},
                    {"radtan", "equidistant", "different distortion models"},
                    {"  distortion_model: radtan\n", "", "no distortion_model"},
                    {"[-0.25, 0.5, 0, 0]", "[-0.25, 0.5, 0]", "has 3 coefficients"},
                    {"[200, 201, 160, 120]", "[200, 201, 160]", "intrinsics is not 4 numbers"},
                    {"[200, 201, 160, 120]", "[200, -201, 160, 120]", "what its intrinsics"},
                    {"[200, 201, 160, 120]", "[200, 201, 160, wide]", "intrinsics is not a list of numbers"},
                    {"resolution: [320, 240]", "resolution: [640, 480]", "images of 640x480 and 320x240"},
                    {"  resolution: [320, 240]\n", "", "of cam0, it has no resolution"},
                    {"  - [1, 0, 0, -0.125]\n", "", "T_cn_cnm1 is not 4x4 numbers"},
                    {"- [0, 0, 0, 1]", "- [-0.125, 0, 0, 1]", "is it transposed?"},
                    {"[1, 0, 0, -0.125]", "[1, 0.1, 0, -0.125]", "T_cn_cnm1 is not a rotation"},
                    {"T_cn_cnm1", "T_cnm1_cn", "it has no T_cn_cnm1"},
                    {"cam1:", "cam2:", "it has no cam1"},
                    {"cam0:", "cam2:\n  rostopic: /x\ncam0:", "more than two cameras"}},
                   [&](const Damage& damage) {
                      return Written{replaced(whole, damage.from, damage.to), ""};
                   });
   EXPECT_NE(sentence({replaced(both, "-0.125", "-0.175"), ""}).find("another motion"), std::string::npos);
   EXPECT_EQ(sentence({both, ""}), "taken");
}

TEST(MatlabCalibration, DamagedOnesAreRefused) {
   const std::string both = matlab(simple_pair()), rows = matlab(simple_pair(), Release::rows);
   const auto damaged = [](const std::string& whole) {
      return [&whole](const Damage& damage) { return Written{replaced(whole, damage.from, damage.to), ""}; };
   };
   expect_refusals({{"[[200, 0, 161],[0, 201, 121],[0, 0, 1]]", "[[200, 0, 0],[0, 201, 0],[161, 121, 1]]",
                     "of CameraParameters1, its K is not a camera matrix"},
                    {"[[200, 0, 161]", "[[222, 0, 161]", "K and IntrinsicMatrix say different things"},
                    {"[[1, 0, 0],[0, 1, 0],[0, 0, 1]]", "[[0, 1, 0],[-1, 0, 0],[0, 0, 1]]",
                     "RotationOfCamera2 and PoseCamera2 say different"},
                    {"[-125, 0, 0]", "[-124, 0, 0]", "TranslationOfCamera2 and PoseCamera2 say different"}},
                   damaged(both));
   expect_refusals(
       {{"[[200, 0, 0],[0, 201, 0],[161, 121, 1]]", "[[200, 0, 161],[0, 201, 121],[0, 0, 1]]",
         "transposed, as MATLAB has it, its IntrinsicMatrix is not a camera matrix"},
        {"[[200, 0, 0],[0, 201, 0],[161, 121, 1]]", "[200, 0, 0, 0, 201, 0, 161, 121, 1]",
         "IntrinsicMatrix is not a list of rows"},
        {"IntrinsicMatrix", "Matrix", "neither K nor IntrinsicMatrix"},
        {"[[1, 0, 0],[0, 1, 0],[0, 0, 1]]", "[[1, 0, 0],[0, 1, 0]]", "RotationOfCamera2 is not 3x3"},
        {"[[1, 0, 0],[0, 1, 0]", "[[1, 0, 0],[0, 3, 0]", "RotationOfCamera2 is not a rotation"},
        {"[-125, 0, 0]", "[-125, 0]", "TranslationOfCamera2 is not 3 numbers"},
        {"[-125, 0, 0]", "[-125, 0, null]", "TranslationOfCamera2 is not a list of numbers"},
        {"[240,320]", "[480,640]", "images of 640x480 and 320x240"},
        {"[240,320]", "[240]", "ImageSize is not 2 numbers"},
        {"\"RadialDistortion\":[-0.25, 0.5, 0]", "\"RadialDistortion\":[-0.25]", "RadialDistortion is not 2 or 3"},
        {"\"ImageSize\"", "\"MappingCoefficients\":[1],\"ImageSize\"", "fisheye model"},
        {"CameraParameters2", "Camera2", "it has no CameraParameters2"},
        {"{", "[", "not a calibration"}},
       damaged(rows));
}

}  // namespace
}  // namespace stereo::app
