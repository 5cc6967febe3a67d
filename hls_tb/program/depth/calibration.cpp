// SPDX-License-Identifier: Apache-2.0
#include "program/depth/calibration.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <opencv2/core.hpp>
#include <set>
#include <sstream>
#include <string_view>

#include "definition/gray_image.hpp"
#include "program/depth/calibration_formats.hpp"
#include "program/depth/calibration_tree.hpp"
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

/// A list of numbers, as cv::Vec and cv::Matx are written, row by row; empty where it does not fit.
cv::Mat matrix_of_list(const cv::FileNode& node, const Entry& entry) {
   const int count = int(node.size());
   const bool vector = entry.rows == 0;
   if (!fits(vector ? 1 : entry.rows, vector ? count : entry.columns, entry)) return {};
   if (!vector && count != entry.rows * entry.columns) return {};
   std::vector<double> numbers;
   for (const cv::FileNode& item : node) {
      if (!item.isReal() && !item.isInt()) return {};
      numbers.push_back(double(item));
   }
   return cv::Mat(numbers, true).reshape(1, vector ? 1 : entry.rows);
}

cv::Mat matrix_of_map(const cv::FileNode& node, const Entry& entry, const std::string& what) {
   // OpenCV allocates whatever size the file names: it is looked at before.
   if (!node.isMap() || !node["rows"].isInt() || !node["cols"].isInt()) throw InputError(what + " has no size");
   const int rows = node["rows"], columns = node["cols"];
   if (rows == 0 && columns == 0) return {};
   if (rows < 1 || columns < 1 || !fits(rows, columns, entry))
      throw InputError(what + " is " + std::to_string(rows) + "x" + std::to_string(columns) + " but must be " +
                       (entry.rows == 0 ? "a vector of 4, 5, 8, 12 or 14 coefficients"
                                        : std::to_string(entry.rows) + "x" + std::to_string(entry.columns)));
   cv::Mat matrix;
   node >> matrix;
   if (matrix.rows != rows || matrix.cols != columns || matrix.channels() != 1)
      throw InputError(what + " has more than one number at a place, or none");
   return matrix;
}

/// `name`: the entry's, or another one that people write.
void take(Calibration& calibration, const cv::FileNode& node, const Entry& entry, const char* name) {
   if (node.empty()) return;
   const std::string what = std::string("its matrix ") + name;
   if (!(calibration.*entry.matrix).empty()) throw InputError(what + " stands beside its " + entry.name);
   cv::Mat matrix;
   if (node.isSeq()) {
      matrix = matrix_of_list(node, entry);
      if (matrix.empty()) throw InputError(what + " is not a list of the right length");
   } else {
      matrix = matrix_of_map(node, entry, what);
   }
   if (matrix.empty()) return;
   cv::Mat& target = calibration.*entry.matrix;
   matrix.convertTo(target, CV_64F);
   if (!is_finite(target)) throw InputError(what + " has values that are not finite");
}

/// Pixels along a side; 0 where the file does not say it.
int side_at(const cv::FileNode& node, const char* name) {
   if (node.empty()) return 0;
   return side_of(node.isInt() ? int(node) : 0, name);
}

/// cv::FileStorage takes the first of several.
void require_each_key_once(const cv::FileNode& map) {
   std::set<std::string> seen;
   for (const cv::FileNode& child : map) {
      if (child.isMap()) require_each_key_once(child);
      if (!seen.insert(child.name()).second) throw InputError("the key " + child.name() + " appears twice");
   }
}

/// Of OpenCV's files.
Calibration read_storage(const std::string& path, const std::string& sentence) {
   const SilentStderr silent;
   const cv::FileStorage file(path, cv::FileStorage::READ);
   if (!file.isOpened() || !file.root().isMap()) throw InputError(sentence);
   require_each_key_once(file.root());
   Calibration calibration;
   for (const Entry& entry : kEntries) take(calibration, file[entry.name], entry, entry.name);
   // As the documentation of cv::fisheye and of cv::stereoRectify has them.
   const bool other_names = !file["K1"].empty() || !file["K2"].empty();
   take(calibration, file["K1"], kEntries[0], "K1");
   take(calibration, file["K2"], kEntries[2], "K2");
   const cv::FileNode model = file["distortion_model"];
   calibration.lens = lens_of_word(model.isString() ? std::string(model) : "");
   const auto is_four = [](const cv::Mat& d) { return d.total() == 4; };
   if (calibration.lens == Lens::unsaid && other_names && (is_four(calibration.d1) || is_four(calibration.d2)))
      calibration.lens = Lens::ambiguous;
   calibration.image_size = {side_at(file["image_width"], "image_width"),
                             side_at(file["image_height"], "image_height")};
   if ((calibration.image_size.width == 0) != (calibration.image_size.height == 0))
      throw InputError("it has one of image_width and image_height, but not both");
   return calibration;
}

std::string text_of(const std::string& path) {
   std::ostringstream text;
   text << std::ifstream(path, std::ios::binary).rdbuf();
   return text.str();
}

/// Of the files but the extrinsics.
Calibration read(const CalibrationFiles& files, const std::string& sentence) {
   const std::string text = text_of(files.path);
   if (!files.right.empty()) return parse_calibrations({files.path, text}, {files.right, text_of(files.right)});
   try {
      if (const auto found = parse_calibration(text)) return *found;
      return read_storage(files.path, sentence);
   } catch (const InputError& problem) {
      const std::string why = problem.what();
      throw InputError(why == sentence ? why : files.path + ": " + why);
   }
}

/// What a child says before its matrices.
struct Heading {
   cv::Size image_size, rectified_size;
   double unit_mm;
   Lens lens;
   std::array<char, 64> unknown_unit;
};

constexpr char kTaken = '+', kRefused = '-';

/// The answer of the child: its size and matrices, or why there are none.
std::string answer(const CalibrationFiles& files, const std::string& sentence) {
   try {
      const Calibration calibration = read(files, sentence);
      std::string bytes(1, kTaken);
      Heading heading{calibration.image_size, calibration.rectified_size, calibration.unit_mm, calibration.lens, {}};
      calibration.unknown_unit.copy(heading.unknown_unit.data(), heading.unknown_unit.size() - 1);
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

/// The calibration of an answer.
Calibration calibration_of(std::string_view bytes) {
   Heading heading{};
   std::memcpy(&heading, bytes.data(), sizeof(heading));
   bytes.remove_prefix(sizeof(heading));
   Calibration calibration;
   calibration.image_size = heading.image_size;
   calibration.rectified_size = heading.rectified_size;
   calibration.unit_mm = heading.unit_mm;
   calibration.lens = heading.lens;
   calibration.unknown_unit = heading.unknown_unit.data();
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
   return calibration;
}

void require_possible_file(const std::string& path, const std::string& sentence) {
   std::error_code error;
   require_file(path, path);
   if (std::filesystem::file_size(path, error) > kLargestFile) throw InputError(sentence);
}

/// Without the extrinsics.
Calibration loaded(const CalibrationFiles& files, std::chrono::milliseconds limit) {
   const std::string sentence = files.path +
                                ": not a calibration that can be read; give a file as OpenCV, ROS, Kalibr, MATLAB or "
                                "a benchmark writes it, as docs/depth.md has them";
   require_possible_file(files.path, sentence);
   if (!files.right.empty()) require_possible_file(files.right, sentence);
   // OpenCV 4.6 crashes on some XML files and never comes back from some YAML files (fuzz/corpus/calibration/).
   const auto found = done_by_child([&] { return answer(files, sentence); }, limit);
   if (!found || found->empty()) throw InputError(sentence);
   if (found->front() == kRefused) throw InputError(found->substr(1));
   return calibration_of(std::string_view(*found).substr(1));
}

/// What a second file says comes before the first one's.
void replace_by(Calibration& calibration, const Calibration& others, const std::string& path) {
   if (!others.image_size.empty() && !calibration.image_size.empty() && others.image_size != calibration.image_size)
      throw InputError(path + ": is of images of " + size_text(others.image_size) +
                       " but the first file is of another size");
   if (!others.image_size.empty()) calibration.image_size = others.image_size;
   if (!others.rectified_size.empty()) calibration.rectified_size = others.rectified_size;
   if (others.unit_mm != 0) calibration.unit_mm = others.unit_mm;
   if (others.lens != Lens::unsaid) {
      if (calibration.lens != Lens::unsaid && calibration.lens != others.lens)
         throw InputError(path + ": has another distortion model than the first file");
      calibration.lens = others.lens;
   }
   for (const Entry& entry : kEntries)
      if (const cv::Mat& matrix = others.*entry.matrix; !matrix.empty()) calibration.*entry.matrix = matrix;
}

/// The lens becomes a known one, to which the coefficients fit.
void settle_lens(Calibration& calibration, const CalibrationFiles& files) {
   if (files.fisheye && calibration.lens == Lens::radial)
      throw InputError("--fisheye: " + files.path + " says that its lenses are of another model");
   if (!files.fisheye && calibration.lens == Lens::ambiguous)
      throw InputError(files.path +
                       ": its 4 coefficients beside K1 and K2 may be k1 k2 p1 p2 or those of cv::fisheye: give "
                       "--fisheye, or write distortion_model: plumb_bob into the file");
   if (files.fisheye) calibration.lens = Lens::fisheye;
   else if (calibration.lens == Lens::unsaid) calibration.lens = Lens::radial;
   if (calibration.lens != Lens::fisheye) return;
   for (const auto& [name, d] : {std::pair{"D1", calibration.d1}, {"D2", calibration.d2}})
      if (!d.empty() && d.total() != 4)
         throw InputError(files.path + ": its " + name + " has " + std::to_string(d.total()) +
                          " coefficients but the fisheye model has 4");
}

}  // namespace

Calibration load_calibration(const CalibrationFiles& files, std::chrono::milliseconds limit) {
   Calibration calibration = loaded(files, limit);
   if (!files.extrinsics.empty())
      replace_by(calibration, loaded({files.extrinsics, "", "", false}, limit), files.extrinsics);
   settle_lens(calibration, files);
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
