// SPDX-License-Identifier: Apache-2.0
#include "program/depth/calibration.hpp"

#include <cmath>
#include <cstring>
#include <filesystem>
#include <opencv2/core.hpp>
#include <string_view>

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
   int rows, columns;  ///< 0: a vector of up to 14
};

constexpr Entry kEntries[] = {
    {"M1", &Calibration::m1, 3, 3}, {"D1", &Calibration::d1, 0, 0}, {"M2", &Calibration::m2, 3, 3},
    {"D2", &Calibration::d2, 0, 0}, {"R", &Calibration::r, 3, 3},   {"T", &Calibration::t, 3, 1},
    {"P1", &Calibration::p1, 3, 4}, {"P2", &Calibration::p2, 3, 4}, {"Q", &Calibration::q, 4, 4}};

bool fits(int rows, int columns, const Entry& entry) {
   if (entry.rows != 0) return rows == entry.rows && columns == entry.columns;
   return (rows == 1 && columns <= 14) || (columns == 1 && rows <= 14);
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
                       (entry.rows == 0 ? "a vector of up to 14"
                                        : std::to_string(entry.rows) + "x" + std::to_string(entry.columns)));
   cv::Mat matrix;
   node >> matrix;
   if (matrix.rows != rows || matrix.cols != columns || matrix.channels() != 1)
      throw InputError(what + " has more than one number at a place, or none");
   cv::Mat& target = calibration.*entry.matrix;
   matrix.convertTo(target, CV_64F);
   if (!is_finite(target)) throw InputError(what + " has values that are not finite");
}

Calibration read(const std::string& path, const std::string& sentence) {
   const SilentStderr silent;
   const cv::FileStorage file(path, cv::FileStorage::READ);
   if (!file.isOpened() || !file.root().isMap()) throw InputError(sentence);
   Calibration calibration;
   for (const Entry& entry : kEntries) take(calibration, file[entry.name], entry, path);
   return calibration;
}

constexpr char kTaken = '+', kRefused = '-';

/// The answer of the child: its matrices, or why there are none.
std::string answer(const std::string& path, const std::string& sentence) {
   try {
      const Calibration calibration = read(path, sentence);
      std::string bytes(1, kTaken);
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

/// The calibration's matrices become those of the answer, where that has some.
void take_answer(Calibration& calibration, std::string_view bytes) {
   for (const Entry& entry : kEntries) {
      const int rows = uint8_t(bytes[0]), columns = uint8_t(bytes[1]);
      bytes.remove_prefix(2);
      if (rows == 0) continue;
      cv::Mat matrix(rows, columns, CV_64F);
      const std::size_t size = matrix.total() * sizeof(double);
      std::memcpy(matrix.data, bytes.data(), size);
      bytes.remove_prefix(size);
      calibration.*entry.matrix = matrix;
   }
}

void read_into(Calibration& calibration, const std::string& path, std::chrono::milliseconds limit) {
   std::error_code error;
   require_file(path, path);
   const std::string sentence =
       path + ": not a calibration that can be read; give a YAML file as OpenCV's stereo_calib writes it";
   if (std::filesystem::file_size(path, error) > kLargestFile) throw InputError(sentence);
   // OpenCV 4.6 crashes on some XML files and never comes back from some YAML files (fuzz/corpus/calibration/).
   const auto found = done_by_child([&] { return answer(path, sentence); }, limit);
   if (!found || found->empty()) throw InputError(sentence);
   if (found->front() == kRefused) throw InputError(found->substr(1));
   take_answer(calibration, std::string_view(*found).substr(1));
}

/// `name`: the matrices that it comes from.
RectifiedGeometry checked(const RectifiedGeometry& geometry, const std::string& name) {
   if (geometry.focal_px <= 0 || geometry.baseline == 0)
      throw InputError("--calibration: its " + name + " lacks the focal length or the baseline of a rectified pair");
   if (geometry.baseline < 0)
      throw InputError(
          "--calibration: its right camera stands to the left of the left one: exchange --left and --right, and "
          "calibrate in that order");
   return geometry;
}

/// `shift`: from the left camera's axis to the right one's, below 0 when that stands to the right.
RectifiedGeometry geometry_of_cameras(const cv::Mat& left, const cv::Mat& right, double shift,
                                      const std::string& name) {
   const double x = left.at<double>(0, 2);
   return checked({left.at<double>(0, 0), -shift, x, left.at<double>(1, 2), x - right.at<double>(0, 2)}, name);
}

}  // namespace

Calibration load_calibration(const std::string& path, const std::string& extrinsics_path,
                             std::chrono::milliseconds limit) {
   Calibration calibration;
   read_into(calibration, path, limit);
   if (!extrinsics_path.empty()) read_into(calibration, extrinsics_path, limit);
   return calibration;
}

RectifiedGeometry geometry_of_q(const cv::Mat& q) {
   const auto at = [&q](int row, int column) { return q.at<double>(row, column); };
   const double baseline = at(3, 2) == 0 ? 0 : 1 / at(3, 2);
   return checked({at(2, 3), baseline, -at(0, 3), -at(1, 3), -at(3, 3) * baseline}, "Q");
}

RectifiedGeometry rectified_geometry(const Calibration& calibration) {
   if (!calibration.q.empty()) return geometry_of_q(calibration.q);
   if (!calibration.p1.empty() && !calibration.p2.empty() && calibration.p2.at<double>(0, 0) != 0)
      return geometry_of_cameras(calibration.p1, calibration.p2,
                                 calibration.p2.at<double>(0, 3) / calibration.p2.at<double>(0, 0), "P1 and P2");
   if (!calibration.m1.empty() && !calibration.t.empty())
      return geometry_of_cameras(calibration.m1, calibration.m2.empty() ? calibration.m1 : calibration.m2,
                                 calibration.t.at<double>(0, 0), "M1 and T");
   throw InputError("--calibration: has neither Q, nor P1 and P2, nor M1 and T, of which a rectified pair needs one");
}

}  // namespace stereo::app
