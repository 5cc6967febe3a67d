// SPDX-License-Identifier: Apache-2.0
// Calibrations as ROS, Kalibr and MATLAB write them, of cameras that are known: what is read is these cameras, and what
// is rectified is what OpenCV makes of them.
#include <gtest/gtest.h>

#include <fstream>
#include <iomanip>
#include <opencv2/calib3d.hpp>
#include <sstream>

#include "program/depth/calibration.hpp"
#include "program/depth/rectification.hpp"
#include "program/errors.hpp"
#include "scene/random.hpp"
#include "testing/seed.hpp"

namespace stereo::app {
namespace {

const cv::Size kSize(320, 240);
constexpr int kRounds = 4;

/// Two cameras, 5 or 4 coefficients each, and what cv::stereoRectify makes of them.
struct Pair {
   cv::Mat m1, d1, m2, d2, r, t;
   cv::Mat r1, r2, p1, p2, q;
   bool fisheye = false;
};

cv::Mat turn(double x, double y, double z) {
   cv::Mat r;
   cv::Rodrigues(cv::Vec3d(x, y, z), r);
   return r;
}

cv::Mat camera(Random& random) {
   const double focal = random.between(180, 260);
   return (cv::Mat_<double>(3, 3) << focal, 0, random.between(150, 170), 0, focal * random.between(0.98, 1.02),
           random.between(110, 130), 0, 0, 1);
}

cv::Mat coefficients(Random& random, bool fisheye) {
   if (fisheye)
      return (cv::Mat_<double>(1, 4) << random.between(-0.05, 0.05), random.between(-0.02, 0.02),
              random.between(-0.01, 0.01), random.between(-0.005, 0.005));
   return (cv::Mat_<double>(1, 5) << random.between(-0.3, 0.1), random.between(-0.05, 0.05),
           random.between(-0.002, 0.002), random.between(-0.002, 0.002), random.between(-0.01, 0.01));
}

void add_rectification(Pair& pair) {
   pair.r1 = pair.r2 = pair.p1 = pair.p2 = pair.q = cv::Mat();  // copies of a pair share their matrices
   if (pair.fisheye)
      cv::fisheye::stereoRectify(pair.m1, pair.d1, pair.m2, pair.d2, kSize, pair.r, pair.t, pair.r1, pair.r2, pair.p1,
                                 pair.p2, pair.q, cv::CALIB_ZERO_DISPARITY, kSize, 0);
   else
      cv::stereoRectify(pair.m1, pair.d1, pair.m2, pair.d2, kSize, pair.r, pair.t, pair.r1, pair.r2, pair.p1, pair.p2,
                        pair.q, cv::CALIB_ZERO_DISPARITY, 0, kSize);
}

Pair random_pair(Random& random, bool fisheye) {
   const auto angle = [&random] { return random.between(-0.04, 0.04); };
   Pair pair;
   pair.m1 = camera(random);
   pair.m2 = camera(random);
   pair.d1 = coefficients(random, fisheye);
   pair.d2 = coefficients(random, fisheye);
   const double x = angle(), y = angle(), z = angle();
   pair.r = turn(x, y, z);
   pair.t = (cv::Mat_<double>(3, 1) << random.between(-0.2, -0.05), random.between(-0.004, 0.004),
             random.between(-0.004, 0.004));
   pair.fisheye = fisheye;
   add_rectification(pair);
   return pair;
}

std::string list(const cv::Mat& matrix) {
   std::ostringstream text;
   text << std::setprecision(17) << '[';
   for (int i = 0; i < int(matrix.total()); ++i) text << (i > 0 ? ", " : "") << matrix.at<double>(i);
   text << ']';
   return text.str();
}

/// Of any matrix, a row a line behind `start`.
std::string rows(const cv::Mat& matrix, const std::string& start, const std::string& end) {
   std::string text;
   for (int i = 0; i < matrix.rows; ++i)
      text.append(start).append(list(matrix.row(i))).append(i + 1 < matrix.rows ? end : "");
   return text;
}

std::string nested(const cv::Mat& matrix) { return "[" + rows(matrix, "", ",") + "]"; }

std::string ros_matrix(const std::string& name, const cv::Mat& matrix) {
   return name + ":\n  rows: " + std::to_string(matrix.rows) + "\n  cols: " + std::to_string(matrix.cols) +
          "\n  data: " + list(matrix) + "\n";
}

/// A file of camera_calibration.
std::string ros_file(const Pair& pair, bool left) {
   return "image_width: 320\nimage_height: 240\ncamera_name: narrow_stereo/" + std::string(left ? "left" : "right") +
          "\n" + ros_matrix("camera_matrix", left ? pair.m1 : pair.m2) +
          (pair.fisheye ? "distortion_model: equidistant\n" : "distortion_model: plumb_bob\n") +
          ros_matrix("distortion_coefficients", left ? pair.d1 : pair.d2) +
          ros_matrix("rectification_matrix", left ? pair.r1 : pair.r2) +
          ros_matrix("projection_matrix", left ? pair.p1 : pair.p2);
}

/// A message, as `ros2 topic echo` prints it.
std::string ros_message(const Pair& pair, bool left) {
   const auto items = [](const std::string& name, const cv::Mat& matrix) {
      return name + ":\n" + rows(matrix.reshape(1, int(matrix.total())), "- ", "\n") + "\n";
   };
   std::string text =
       "header:\n  stamp:\n    sec: 1\n    nanosec: 2\n  frame_id: 'camera: left # 1'\nheight: 240\nwidth: 320\n";
   text += pair.fisheye ? "distortion_model: equidistant\n" : "distortion_model: plumb_bob\n";
   for (const auto& [name, matrix] : {std::pair{"d", left ? pair.d1 : pair.d2},
                                      {"k", left ? pair.m1 : pair.m2},
                                      {"r", left ? pair.r1 : pair.r2},
                                      {"p", left ? pair.p1 : pair.p2}})
      text += items(name, matrix);
   text +=
       "binning_x: 0\nbinning_y: 0\nroi:\n  x_offset: 0\n  y_offset: 0\n  height: 0\n  width: 0\n  do_rectify: "
       "false\n---\n";
   // A message has plain numbers behind its dashes.
   for (std::size_t at = 0; (at = text.find("- [", at)) != std::string::npos;) text.erase(at + 2, 1);
   for (std::size_t at = 0; (at = text.find("]\n", at)) != std::string::npos;) text.erase(at, 1);
   return text;
}

/// Both cameras in one file, further to the right.
std::string ros_both(const Pair& pair) {
   std::string text = "# both cameras\n";
   for (const bool left : {true, false}) {
      text += left ? "left:\n" : "right:\n";
      std::istringstream lines(ros_file(pair, left));
      for (std::string line; std::getline(lines, line);) text += "   " + line + "\n";
   }
   return text;
}

cv::Mat motion_of(const cv::Mat& r, const cv::Mat& t) {
   cv::Mat motion = cv::Mat::eye(4, 4, CV_64F);
   r.copyTo(motion(cv::Rect(0, 0, 3, 3)));
   t.copyTo(motion(cv::Rect(3, 0, 1, 3)));
   return motion;
}

enum class Chain { direct, imu, both };

/// Kalibr has four coefficients.
std::string kalibr(const Pair& pair, Chain chain = Chain::direct) {
   const cv::Mat imu = motion_of(turn(1, -2, 0.5), (cv::Mat_<double>(3, 1) << 0.3, -0.2, 0.1));
   const cv::Mat motion = motion_of(pair.r, pair.t);
   std::string text;
   for (const bool left : {true, false}) {
      const cv::Mat &m = left ? pair.m1 : pair.m2, &d = left ? pair.d1 : pair.d2;
      text += left ? "cam0:\n  cam_overlaps: [1]\n" : "cam1:\n";
      if (!left && chain != Chain::imu) text += "  T_cn_cnm1:\n" + rows(motion, "  - ", "\n") + "\n";
      if (chain != Chain::direct)
         text += "  T_cam_imu:\n" + rows(left ? imu : cv::Mat(motion * imu), "  - ", "\n") + "\n";
      if (!left) text += "  cam_overlaps: [0]\n";
      text += "  camera_model: pinhole\n  distortion_coeffs: " + list(d.colRange(0, 4)) +
              "\n  distortion_model: " + (pair.fisheye ? "equidistant" : "radtan") + "\n  intrinsics: " +
              list((cv::Mat_<double>(1, 4) << m.at<double>(0, 0), m.at<double>(1, 1), m.at<double>(0, 2),
                    m.at<double>(1, 2))) +
              "\n  resolution: [320, 240]\n  rostopic: /cam" + (left ? "0" : "1") + "/image_raw\n";
   }
   return text;
}

enum class Release { rows, columns, both };

/// Lengths in millimetres, the first pixel is 1.
std::string matlab(const Pair& pair, Release release = Release::both) {
   const cv::Mat t = 1000 * pair.t;
   const auto camera = [&](const cv::Mat& zero_based, const cv::Mat& d) {
      cv::Mat m = zero_based.clone();
      m.at<double>(0, 2) += 1;
      m.at<double>(1, 2) += 1;
      const cv::Mat radial = (cv::Mat_<double>(1, 3) << d.at<double>(0), d.at<double>(1), d.at<double>(4));
      std::string text = "{\"ImageSize\":[240,320],\"RadialDistortion\":" + list(radial) +
                         ",\"TangentialDistortion\":" + list(d.colRange(2, 4)) + ",\"WorldUnits\":\"millimeters\"";
      if (release != Release::columns) text += ",\"IntrinsicMatrix\":" + nested(m.t());
      if (release != Release::rows) text += ",\"K\":" + nested(m);
      return text + ",\"ReprojectionErrors\":[[[0.1]],null]}";
   };
   std::string text =
       R"({"CameraParameters1":)" + camera(pair.m1, pair.d1) + R"(,"CameraParameters2":)" + camera(pair.m2, pair.d2);
   if (release != Release::columns)
      text += ",\"RotationOfCamera2\":" + nested(pair.r.t()) + ",\"TranslationOfCamera2\":" + list(t);
   if (release != Release::rows)
      text += ",\"PoseCamera2\":{\"Dimensionality\":3,\"R\":" + nested(pair.r) + ",\"Translation\":" + list(t) + "}";
   return text + ",\"WorldUnits\":\"millimeters\"}";
}

std::string opencv_matrix(const std::string& name, const cv::Mat& matrix) {
   return name + ": !!opencv-matrix\n   rows: " + std::to_string(matrix.rows) +
          "\n   cols: " + std::to_string(matrix.cols) + "\n   dt: d\n   data: " + list(matrix) + "\n";
}

/// As programs around cv::fisheye write it, or others.
std::string opencv(const Pair& pair, const std::string& m, const std::string& more = "") {
   return "%YAML:1.0\n---\n" + opencv_matrix(m + "1", pair.m1) + opencv_matrix(m + "2", pair.m2) +
          "D1: " + list(pair.d1) + "\nD2: " + list(pair.d2) + "\n" + opencv_matrix("R", pair.r) + "T: " + list(pair.t) +
          "\n" + more;
}

struct Written {
   std::string left, right;  ///< empty: one file
   bool fisheye = false;     ///< said by the user
};

Calibration load(const Written& written) {
   const std::string folder = testing::TempDir();
   const auto file = [&folder](const char* name, const std::string& text) {
      if (text.empty()) return std::string();
      std::ofstream(folder + name, std::ios::binary) << text;
      return folder + name;
   };
   return load_calibration({file("left.yaml", written.left), file("right.yaml", written.right), "", written.fisheye});
}

std::string sentence(const Written& written) {
   try {
      load(written);
   } catch (const InputError& problem) {
      return problem.what();
   }
   return "taken";
}

void expect_same(const cv::Mat& found, const cv::Mat& wanted, double tolerance, const char* what) {
   ASSERT_EQ(found.size(), wanted.size()) << what;
   EXPECT_LE(cv::norm(found, wanted, cv::NORM_INF), tolerance) << what << "\n" << found << "\n" << wanted;
}

/// The cameras, and the rectification that OpenCV makes of them. `unit`: of T.
void expect_pair(const Calibration& found, const Pair& pair, double unit_mm) {
   constexpr double kTolerance = 1e-9;
   expect_same(found.m1, pair.m1, kTolerance, "M1");
   expect_same(found.m2, pair.m2, kTolerance, "M2");
   expect_same(found.r, pair.r, kTolerance, "R");
   expect_same(found.t * unit_mm / 1000, pair.t, kTolerance, "T");
   EXPECT_EQ(found.unit_mm, unit_mm);
   EXPECT_EQ(found.image_size, kSize);
   EXPECT_EQ(found.lens, pair.fisheye ? Lens::fisheye : Lens::radial);
   const Rectification made = make_rectification(found, kSize.width, kSize.height);
   EXPECT_NEAR(made.geometry.focal_px(), pair.q.at<double>(2, 3), 1e-6);
   EXPECT_NEAR(made.geometry.baseline() * unit_mm / 1000, 1 / pair.q.at<double>(3, 2), 1e-9);
   EXPECT_NEAR(made.geometry.cx_px(), -pair.q.at<double>(0, 3), 1e-6);
   cv::Mat x, y;
   const auto maps = [&](const cv::Mat& m, const cv::Mat& d, const cv::Mat& r, const cv::Mat& p) {
      if (pair.fisheye) cv::fisheye::initUndistortRectifyMap(m, d, r, p, kSize, CV_32FC1, x, y);
      else cv::initUndistortRectifyMap(m, d, r, p, kSize, CV_32FC1, x, y);
   };
   maps(pair.m1, pair.d1, pair.r1, pair.p1);
   expect_same(made.left_x, x, 1e-3, "left x");
   expect_same(made.left_y, y, 1e-3, "left y");
   maps(pair.m2, pair.d2, pair.r2, pair.p2);
   expect_same(made.right_x, x, 1e-3, "right x");
   expect_same(made.right_y, y, 1e-3, "right y");
}

TEST(RosCalibration, IsThePairThatWasCalibrated) {
   Random random(test::test_seed());
   for (int round = 0; round < kRounds; ++round)
      for (const bool fisheye : {false, true}) {
         const Pair pair = random_pair(random, fisheye);
         for (const Written& written : {Written{ros_file(pair, true), ros_file(pair, false)},
                                        {ros_message(pair, true), ros_message(pair, false)},
                                        {ros_both(pair), ""}}) {
            const Calibration found = load(written);
            expect_pair(found, pair, 1000);
            expect_same(found.d1, pair.d1, 0, "D1");
            const RectifiedGeometry rectified = rectified_geometry(found);
            EXPECT_NEAR(rectified.focal_px(), pair.q.at<double>(2, 3), 1e-9);
            EXPECT_NEAR(rectified.baseline(), 1 / pair.q.at<double>(3, 2), 1e-9);
         }
      }
}

/// Without k3, which Kalibr does not have.
Pair without_fifth(Pair pair) {
   if (pair.fisheye) return pair;
   pair.d1.at<double>(4) = pair.d2.at<double>(4) = 0;
   add_rectification(pair);
   return pair;
}

TEST(KalibrCalibration, IsThePairThatWasCalibrated) {
   Random random(test::test_seed());
   for (int round = 0; round < kRounds; ++round)
      for (const bool fisheye : {false, true})
         for (const Chain chain : {Chain::direct, Chain::imu, Chain::both}) {
            const Pair pair = without_fifth(random_pair(random, fisheye));
            const Calibration found = load({kalibr(pair, chain), ""});
            expect_pair(found, pair, 1000);
            expect_same(found.d2, pair.d2.colRange(0, 4), 0, "D2");
         }
}

TEST(MatlabCalibration, IsThePairThatWasCalibrated) {
   Random random(test::test_seed());
   for (int round = 0; round < kRounds; ++round)
      for (const Release release : {Release::rows, Release::columns, Release::both}) {
         const Pair pair = random_pair(random, false);
         const std::string text = matlab(pair, release);
         for (const std::string& whole : {text, "{\"stereoParams\":" + text + "}"}) {
            const Calibration found = load({whole, ""});
            expect_pair(found, pair, 1);
            expect_same(found.d1, pair.d1, 0, "D1");
         }
      }
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
   const std::size_t at = text.find(from);
   if (at == std::string::npos) throw std::logic_error("the text has no " + from);
   return text.replace(at, from.size(), to);
}

TEST(MatlabCalibration, UnitsAreThoseOfItsWord) {
   Random random(test::test_seed());
   const Pair pair = random_pair(random, false);
   const std::string text = matlab(pair);
   const std::string end = "\"WorldUnits\":\"millimeters\"}";
   const auto with = [&](const std::string& units) {
      return load({text.substr(0, text.size() - end.size()) + units + "}", ""});
   };
   EXPECT_EQ(with("\"WorldUnits\":\"m\"").unit_mm, 1000);
   EXPECT_EQ(with("\"WorldUnits\":\"inches\"").unit_mm, 25.4);
   EXPECT_EQ(with("\"WorldUnits\":\"squares\"").unit_mm, 0);
   EXPECT_NE(with("\"WorldUnits\":\"squares\"").unknown_unit.find("squares"), std::string::npos);
   EXPECT_EQ(with("\"NumPatterns\":1").unit_mm, 1) << "that of CameraParameters1";
}

TEST(OpenCvCalibration, FisheyeIsSaidByTheFileOrTheUser) {
   Random random(test::test_seed());
   const Pair fisheye = random_pair(random, true);
   Pair radial = fisheye;
   radial.fisheye = false;
   add_rectification(radial);
   const std::string model = "distortion_model: ";
   const auto expect = [](const Written& written, const Pair& pair) {
      const Calibration found = load(written);
      EXPECT_EQ(found.lens, pair.fisheye ? Lens::fisheye : Lens::radial);
      const Rectification made = make_rectification(found, kSize.width, kSize.height);
      EXPECT_NEAR(made.geometry.focal_px(), pair.q.at<double>(2, 3), 1e-6);
   };
   expect({opencv(fisheye, "M", model + "equidistant\n"), ""}, fisheye);
   expect({opencv(fisheye, "K", model + "fisheye\n"), ""}, fisheye);
   expect({opencv(fisheye, "M"), "", true}, fisheye);
   expect({opencv(fisheye, "K"), "", true}, fisheye);
   expect({opencv(radial, "M"), ""}, radial);
   expect({opencv(radial, "K", model + "plumb_bob\n"), ""}, radial);
   EXPECT_NE(std::abs(fisheye.q.at<double>(2, 3) - radial.q.at<double>(2, 3)), 0) << "else nothing was told";
   EXPECT_NE(sentence({opencv(fisheye, "K"), ""}).find("give --fisheye"), std::string::npos);
   EXPECT_NE(sentence({opencv(radial, "M", model + "plumb_bob\n"), "", true}).find("of another model"),
             std::string::npos);
   EXPECT_NE(sentence({opencv(radial, "M", model + "scaramuzza\n"), ""}).find("distortion_model is scaramuzza"),
             std::string::npos);
   const Pair five = random_pair(random, false);
   EXPECT_NE(sentence({opencv(five, "M", model + "equidistant\n"), ""}).find("5 coefficients"), std::string::npos);
   EXPECT_NE(sentence({opencv(five, "K", opencv_matrix("M1", five.m1)), ""}).find("K1 stands beside its M1"),
             std::string::npos);
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

/// Whole numbers, so that they can be found in a text.
Pair simple_pair(bool fisheye = false) {
   Pair pair;
   pair.m1 = pair.m2 = (cv::Mat_<double>(3, 3) << 200, 0, 160, 0, 201, 120, 0, 0, 1);
   pair.d1 =
       fisheye ? (cv::Mat_<double>(1, 4) << 0.01, 0.02, 0.03, 0.04) : (cv::Mat_<double>(1, 5) << -0.25, 0.5, 0, 0, 0);
   pair.d2 = pair.d1.clone();
   pair.r = cv::Mat::eye(3, 3, CV_64F);
   pair.t = (cv::Mat_<double>(3, 1) << -0.125, 0, 0);
   pair.r1 = pair.r2 = pair.r;
   pair.p1 = (cv::Mat_<double>(3, 4) << 190, 0, 160, 0, 0, 190, 120, 0, 0, 0, 1, 0);
   pair.p2 = (cv::Mat_<double>(3, 4) << 190, 0, 160, -19, 0, 190, 120, 0, 0, 0, 1, 0);
   pair.fisheye = fisheye;
   return pair;
}

TEST(RosCalibration, DamagedOnesAreRefused) {
   const Pair pair = simple_pair();
   const std::string left = ros_file(pair, true), right = ros_file(pair, false);
   expect_refusals(
       {{"image_width: 320", "image_width: 640", "images of 320x240 and 640x240"},
        {"image_width: 320\n", "", "it has no image_width"},
        {"image_width: 320", "image_width: 0", "image_width is no number of pixels"},
        {"image_width: 320", "image_width: 1e9", "image_width is no number of pixels"},
        {"plumb_bob", "equidistant", "has 5 coefficients"},
        {"plumb_bob", "kannala", "distortion_model is kannala"},
        {"distortion_model: plumb_bob\n", "", "no distortion_model"},
        {"[-0.25, 0.5, 0, 0, 0]", "[-0.25, 0.5, 0]", "has 3 coefficients"},
        {"[200, 0, 160, 0, 201, 120, 0, 0, 1]", "[200, 0, 0, 0, 201, 0, 160, 120, 1]",
         "its camera_matrix is no camera matrix"},
        {"[200, 0, 160, 0, 201, 120, 0, 0, 1]", "[0, 0, 0, 0, 0, 0, 0, 0, 0]", "was not calibrated"},
        {"[200, 0, 160, 0, 201, 120, 0, 0, 1]", "[200, 0, 160, 0, 201, 120, 0, 0]", "camera_matrix is not 3x3 numbers"},
        {"[200, 0, 160, 0, 201, 120, 0, 0, 1]", "[200, 0, 160, 0, .nan, 120, 0, 0, 1]",
         "camera_matrix is no list of numbers"},
        {"[1, 0, 0, 0, 1, 0, 0, 0, 1]", "[2, 0, 0, 0, 1, 0, 0, 0, 1]", "rectification_matrix is no rotation"},
        {"[190, 0, 160, -19, 0, 190, 120, 0, 0, 0, 1, 0]", "[190, 0, 0, 0, 190, 0, 160, 120, 1, -19, 0, 0]",
         "its projection_matrix is no camera matrix"},
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
   EXPECT_TRUE(load({none, right}).d1.empty());
}

TEST(RosCalibration, CamerasThatTurnAndStandOtherwise) {
   Pair pair = simple_pair();
   pair.p2 = (cv::Mat_<double>(3, 4) << 190, 0, 160, 0, 0, 190, 120, -19, 0, 0, 1, 0);
   const Calibration upright = load({ros_file(pair, true), ros_file(pair, false)});
   EXPECT_THROW(make_rectification(upright, kSize.width, kSize.height), InputError);
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
                    {"[200, 201, 160, 120]", "[200, 201, 160, wide]", "intrinsics is no list of numbers"},
                    {"resolution: [320, 240]", "resolution: [640, 480]", "images of 640x480 and 320x240"},
                    {"  resolution: [320, 240]\n", "", "of cam0, it has no resolution"},
                    {"  - [1, 0, 0, -0.125]\n", "", "T_cn_cnm1 is not 4x4 numbers"},
                    {"- [0, 0, 0, 1]", "- [-0.125, 0, 0, 1]", "is it transposed?"},
                    {"[1, 0, 0, -0.125]", "[1, 0.1, 0, -0.125]", "T_cn_cnm1 is no rotation"},
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
                     "of CameraParameters1, its K is no camera matrix"},
                    {"[[200, 0, 161]", "[[222, 0, 161]", "K and IntrinsicMatrix say different things"},
                    {"[[1, 0, 0],[0, 1, 0],[0, 0, 1]]", "[[0, 1, 0],[-1, 0, 0],[0, 0, 1]]",
                     "RotationOfCamera2 and PoseCamera2 say different"},
                    {"[-125, 0, 0]", "[-124, 0, 0]", "TranslationOfCamera2 and PoseCamera2 say different"}},
                   damaged(both));
   expect_refusals(
       {{"[[200, 0, 0],[0, 201, 0],[161, 121, 1]]", "[[200, 0, 161],[0, 201, 121],[0, 0, 1]]",
         "transposed, as MATLAB has it, its IntrinsicMatrix is no camera matrix"},
        {"[[200, 0, 0],[0, 201, 0],[161, 121, 1]]", "[200, 0, 0, 0, 201, 0, 161, 121, 1]",
         "IntrinsicMatrix is no list of rows"},
        {"IntrinsicMatrix", "Matrix", "neither K nor IntrinsicMatrix"},
        {"[[1, 0, 0],[0, 1, 0],[0, 0, 1]]", "[[1, 0, 0],[0, 1, 0]]", "RotationOfCamera2 is not 3x3"},
        {"[[1, 0, 0],[0, 1, 0]", "[[1, 0, 0],[0, 3, 0]", "RotationOfCamera2 is no rotation"},
        {"[-125, 0, 0]", "[-125, 0]", "TranslationOfCamera2 is not 3 numbers"},
        {"[-125, 0, 0]", "[-125, 0, null]", "TranslationOfCamera2 is no list of numbers"},
        {"[240,320]", "[480,640]", "images of 640x480 and 320x240"},
        {"[240,320]", "[240]", "ImageSize is not 2 numbers"},
        {"\"RadialDistortion\":[-0.25, 0.5, 0]", "\"RadialDistortion\":[-0.25]", "RadialDistortion is not 2 or 3"},
        {"\"ImageSize\"", "\"MappingCoefficients\":[1],\"ImageSize\"", "fisheye model"},
        {"CameraParameters2", "Camera2", "it has no CameraParameters2"},
        {"{", "[", "not a calibration"}},
       damaged(rows));
}

TEST(FisheyeRectification, CamerasThatStandOtherwiseAreRefused) {
   const auto refusal = [](const cv::Mat& t) {
      const Pair pair = simple_pair(true);
      Calibration calibration = load({kalibr(pair), ""});
      calibration.t = t;
      try {
         make_rectification(calibration, kSize.width, kSize.height);
      } catch (const InputError& problem) {
         return std::string(problem.what());
      }
      return std::string("taken");
   };
   EXPECT_EQ(refusal((cv::Mat_<double>(3, 1) << -0.1, 0, 0)), "taken");
   EXPECT_NE(refusal((cv::Mat_<double>(3, 1) << -0.01, -0.1, 0)).find("one above the other"), std::string::npos);
   EXPECT_NE(refusal((cv::Mat_<double>(3, 1) << -0.01, 0, 0.1)).find("one behind the other"), std::string::npos);
   EXPECT_NE(refusal((cv::Mat_<double>(3, 1) << 0.1, 0, 0)).find("exchange"), std::string::npos);
   EXPECT_NE(refusal((cv::Mat_<double>(3, 1) << 0, 0, 0)), "taken");
}

/// Where a lens puts what lies in a direction, from the definition of its model.
cv::Point2d seen(const cv::Vec3d& point, const cv::Mat& m, const cv::Mat& d, bool fisheye) {
   const auto k = [&d](int i) { return i < int(d.total()) ? d.at<double>(i) : 0; };
   double x = point[0] / point[2], y = point[1] / point[2];
   const double r2 = x * x + y * y;
   if (fisheye) {
      const double r = std::sqrt(r2), a = std::atan(r), a2 = a * a;
      const double bent = a * (1 + a2 * (k(0) + a2 * (k(1) + a2 * (k(2) + a2 * k(3)))));
      x *= r > 0 ? bent / r : 1;
      y *= r > 0 ? bent / r : 1;
   } else {
      const double radial = 1 + r2 * (k(0) + r2 * (k(1) + r2 * k(4))), p1 = k(2), p2 = k(3), u = x, v = y;
      x = u * radial + 2 * p1 * u * v + p2 * (r2 + 2 * u * u);
      y = v * radial + p1 * (r2 + 2 * v * v) + 2 * p2 * u * v;
   }
   return {m.at<double>(0, 0) * x + m.at<double>(0, 2), m.at<double>(1, 1) * y + m.at<double>(1, 2)};
}

TEST(Rectification, APointIsSeenInTheSameRowAndAtItsDepth) {
   Random random(test::test_seed());
   for (int round = 0; round < kRounds; ++round)
      for (const bool fisheye : {false, true}) {
         const Pair pair = random_pair(random, fisheye);
         const Rectification made = make_rectification(load({ros_both(pair), ""}), kSize.width, kSize.height);
         for (int i = 0; i < 50; ++i) {
            const int x = 40 + random.below(240), y = 20 + random.below(200), d = 1 + random.below(32);
            const cv::Vec4d place = made.geometry.q * cv::Vec4d(x, y, d, 1);
            const cv::Mat point = (cv::Mat_<double>(3, 1) << place[0], place[1], place[2]) / place[3];
            const cv::Mat in_left = pair.r1.t() * point, in_right = pair.r * in_left + pair.t;
            const auto vector = [](const cv::Mat& v) { return cv::Vec3d(v.ptr<double>()); };
            const cv::Point2d left = seen(vector(in_left), pair.m1, pair.d1, fisheye);
            const cv::Point2d right = seen(vector(in_right), pair.m2, pair.d2, fisheye);
            EXPECT_NEAR(made.left_x.at<float>(y, x), left.x, 1e-3);
            EXPECT_NEAR(made.left_y.at<float>(y, x), left.y, 1e-3);
            EXPECT_NEAR(made.right_x.at<float>(y, x - d), right.x, 1e-3);
            EXPECT_NEAR(made.right_y.at<float>(y, x - d), right.y, 1e-3);
         }
      }
}

}  // namespace
}  // namespace stereo::app
