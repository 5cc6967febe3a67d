// SPDX-License-Identifier: Apache-2.0
#include "program/depth/calibration.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <opencv2/core.hpp>
#include <sstream>
#include <string_view>

#include "definition/gray_image.hpp"
#include "program/depth/benchmark_calibration.hpp"
#include "program/errors.hpp"
#include "program/io/child_process.hpp"
#include "program/io/require_file.hpp"
#include "program/io/silent_stderr.hpp"

namespace stereo::app {
namespace {

constexpr uintmax_t kLargestFile = 16 << 20;  ///< bytes; a calibration takes some thousand

struct Entry {
   const char* name;
   cv::Mat Calibration::*matrix;
   int rows, columns;  ///< 0: a vector of distortion coefficients
};

constexpr Entry kEntries[] = {
    {"M1", &Calibration::m1, 3, 3}, {"D1", &Calibration::d1, 0, 0}, {"M2", &Calibration::m2, 3, 3},
    {"D2", &Calibration::d2, 0, 0}, {"R", &Calibration::r, 3, 3},   {"T", &Calibration::t, 3, 1},
    {"P1", &Calibration::p1, 3, 4}, {"P2", &Calibration::p2, 3, 4}, {"Q", &Calibration::q, 4, 4}};

/// Numbers of coefficients that OpenCV has a model of.
constexpr int kDistortions[] = {4, 5, 8, 12, 14};

bool fits(int rows, int columns, const Entry& entry) {
   if (entry.rows != 0) return rows == entry.rows && columns == entry.columns;
   const int count = rows * columns;
   return (rows == 1 || columns == 1) &&
          std::find(std::begin(kDistortions), std::end(kDistortions), count) != std::end(kDistortions);
}

bool is_finite(const cv::Mat_<double>& matrix) {
   for (const double value : matrix)
      if (!std::isfinite(value)) return false;
   return true;
}

void take(Calibration& calibration, const cv::FileNode& node, const Entry& entry, const std::string& path) {
   if (node.empty()) return;
   const std::string what = path + ": its matrix " + entry.name;
   // OpenCV allocates whatever size the file names: it is looked at before.
   if (!node.isMap() || !node["rows"].isInt() || !node["cols"].isInt()) throw InputError(what + " has no size");
   const int rows = node["rows"], columns = node["cols"];
   if (rows == 0 && columns == 0) return;
   if (rows < 1 || columns < 1 || !fits(rows, columns, entry))
      throw InputError(what + " is " + std::to_string(rows) + "x" + std::to_string(columns) + " but must be " +
                       (entry.rows == 0 ? "a vector of 4, 5, 8, 12 or 14 coefficients"
                                        : std::to_string(entry.rows) + "x" + std::to_string(entry.columns)));
   cv::Mat matrix;
   node >> matrix;
   if (matrix.rows != rows || matrix.cols != columns || matrix.channels() != 1)
      throw InputError(what + " has more than one number at a place, or none");
   cv::Mat& target = calibration.*entry.matrix;
   matrix.convertTo(target, CV_64F);
   if (!is_finite(target)) throw InputError(what + " has values that are not finite");
}

/// Pixels along a side; 0 where the file does not say it.
int side_of(const cv::FileNode& node, const char* name, const std::string& path) {
   if (node.empty()) return 0;
   const int side = node.isInt() ? int(node) : 0;
   if (side < 1) throw InputError(path + ": its " + name + " is no number of pixels");
   return side;
}

/// Throws InputError where the coefficients are not those of cv::undistort.
void require_known_model(const cv::FileNode& node, const std::string& path) {
   if (!node.isString()) return;
   const std::string model = node;
   for (const char* const known : {"", "plumb_bob", "rational_polynomial", "radtan"})
      if (model == known) return;
   throw InputError(path + ": its distortion_model is " + model +
                    ", but only plumb_bob and rational_polynomial, k1 k2 p1 p2 ..., are known");
}

Calibration read(const std::string& path, const std::string& sentence) {
   std::ostringstream text;
   text << std::ifstream(path, std::ios::binary).rdbuf();
   try {
      if (const auto found = parse_benchmark_calibration(text.view())) return *found;
   } catch (const InputError& problem) {
      throw InputError(path + ": " + problem.what());
   }
   const SilentStderr silent;
   const cv::FileStorage file(path, cv::FileStorage::READ);
   if (!file.isOpened() || !file.root().isMap()) throw InputError(sentence);
   Calibration calibration;
   for (const Entry& entry : kEntries) take(calibration, file[entry.name], entry, path);
   require_known_model(file["distortion_model"], path);
   calibration.image_size = {side_of(file["image_width"], "image_width", path),
                             side_of(file["image_height"], "image_height", path)};
   return calibration;
}

/// What a child says before its matrices.
struct Heading {
   cv::Size image_size, rectified_size;
   double unit_mm;
};

constexpr char kTaken = '+', kRefused = '-';

/// The answer of the child: its size and matrices, or why there are none.
std::string answer(const std::string& path, const std::string& sentence) {
   try {
      const Calibration calibration = read(path, sentence);
      std::string bytes(1, kTaken);
      const Heading heading{calibration.image_size, calibration.rectified_size, calibration.unit_mm};
      bytes.append(reinterpret_cast<const char*>(&heading), sizeof(heading));
      for (const Entry& entry : kEntries) {
         const cv::Mat& matrix = calibration.*entry.matrix;
         for (const int size : {matrix.rows, matrix.cols}) bytes += char(size);
         bytes.append(reinterpret_cast<const char*>(matrix.data), matrix.total() * sizeof(double));
      }
      return bytes;
   } catch (const InputError& problem) {
      return kRefused + std::string(problem.what());
   }
}

/// The calibration's matrices become those of the answer, where that has some. Whether the sizes agree.
bool take_answer(Calibration& calibration, std::string_view bytes) {
   Heading heading{};
   std::memcpy(&heading, bytes.data(), sizeof(heading));
   bytes.remove_prefix(sizeof(heading));
   const cv::Size size = heading.image_size;
   if (!heading.rectified_size.empty()) calibration.rectified_size = heading.rectified_size;
   if (heading.unit_mm != 0) calibration.unit_mm = heading.unit_mm;
   const bool agree = size.empty() || calibration.image_size.empty() || size == calibration.image_size;
   if (!size.empty()) calibration.image_size = size;
   for (const Entry& entry : kEntries) {
      const int rows = uint8_t(bytes[0]), columns = uint8_t(bytes[1]);
      bytes.remove_prefix(2);
      if (rows == 0) continue;
      cv::Mat matrix(rows, columns, CV_64F);
      const std::size_t count = matrix.total() * sizeof(double);
      std::memcpy(matrix.data, bytes.data(), count);
      bytes.remove_prefix(count);
      calibration.*entry.matrix = matrix;
   }
   return agree;
}

void read_into(Calibration& calibration, const std::string& path, std::chrono::milliseconds limit) {
   std::error_code error;
   require_file(path, path);
   const std::string sentence = path +
                                ": not a calibration that can be read; give a YAML file as OpenCV's stereo_calib "
                                "writes it, or the calib.txt of a benchmark";
   if (std::filesystem::file_size(path, error) > kLargestFile) throw InputError(sentence);
   // OpenCV 4.6 crashes on some XML files and never comes back from some YAML files (fuzz/corpus/calibration/).
   const auto found = done_by_child([&] { return answer(path, sentence); }, limit);
   if (!found || found->empty()) throw InputError(sentence);
   if (found->front() == kRefused) throw InputError(found->substr(1));
   if (!take_answer(calibration, std::string_view(*found).substr(1)))
      throw InputError(path + ": is of images of " + size_text(calibration.image_size) +
                       " but the first file is of another size");
}

}  // namespace

Calibration load_calibration(const std::string& path, const std::string& extrinsics_path,
                             std::chrono::milliseconds limit) {
   Calibration calibration;
   read_into(calibration, path, limit);
   if (!extrinsics_path.empty()) read_into(calibration, extrinsics_path, limit);
   return calibration;
}

namespace {

/// Of a pinhole camera, P or M, in place.
void scale_camera(cv::Mat& camera, double x, double y) {
   if (camera.empty()) return;
   // Pixels have their middle at whole numbers.
   const cv::Mat scaled = (cv::Mat_<double>(3, 3) << x, 0, (x - 1) / 2, 0, y, (y - 1) / 2, 0, 0, 1);
   camera = cv::Mat(scaled * camera);  // not in place: others share the matrix
}

}  // namespace

Calibration fitted_calibration(const Calibration& calibration, cv::Size images, cv::Size calibrated) {
   if (!calibrated.empty() && !calibration.image_size.empty() && calibrated != calibration.image_size)
      throw InputError("--calibrated-size " + size_text(calibrated) + ": the calibration says " +
                       size_text(calibration.image_size));
   const cv::Size from = calibrated.empty() ? calibration.image_size : calibrated;
   if (from.empty() || from == images) return calibration;
   const std::string sizes =
       "the cameras were calibrated with images of " + size_text(from) + " but these are " + size_text(images);
   if (calibrated.empty())
      throw InputError("--calibration: " + sizes + "; give images of that size, or --calibrated-size " +
                       size_text(from) + " where these are the same images scaled");
   if (std::abs(double(images.width) * from.height - double(images.height) * from.width) > from.width)
      throw InputError("--calibrated-size: " + sizes + ", which no scaling makes of them");
   const double x = double(images.width) / from.width, y = double(images.height) / from.height;
   Calibration scaled = calibration;
   scaled.image_size = images;
   for (cv::Mat* const camera : {&scaled.m1, &scaled.m2, &scaled.p1, &scaled.p2}) scale_camera(*camera, x, y);
   if (!scaled.q.empty())
      scaled.q = cv::Mat(scaled.q * (cv::Mat_<double>(4, 4) << 1 / x, 0, 0, (1 / x - 1) / 2, 0, 1 / y, 0,
                                     (1 / y - 1) / 2, 0, 0, 1 / x, 0, 0, 0, 0, 1));
   return scaled;
}

}  // namespace stereo::app
