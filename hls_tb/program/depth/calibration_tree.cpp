// SPDX-License-Identifier: Apache-2.0
#include "program/depth/calibration_tree.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <opencv2/core.hpp>
#include <optional>
#include <sstream>
#include <string_view>

#include "program/errors.hpp"
#include "program/io/shown_word.hpp"

namespace stereo::app {
namespace {

std::optional<double> number_of(const Tree& node) {
   double number = 0;
   if (node.is_number()) {
      number = node.get<double>();
   } else if (node.is_string()) {
      std::string_view text = node.get_ref<const std::string&>();
      if (text.starts_with('+')) text.remove_prefix(1);
      const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
      if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
   } else {
      return std::nullopt;
   }
   return std::isfinite(number) ? std::optional(number) : std::nullopt;
}

[[noreturn]] void refuse_matrix(const std::string& name, int rows, int columns) {
   throw InputError("its " + name + " is not " + std::to_string(rows) + "x" + std::to_string(columns) + " numbers");
}

}  // namespace

const Tree* member(const Tree& tree, std::initializer_list<const char*> names) {
   if (!tree.is_object()) return nullptr;
   for (const char* const name : names)
      if (const auto found = tree.find(name); found != tree.end()) return &*found;
   return nullptr;
}

const Tree& required_member(const Tree& tree, std::initializer_list<const char*> names) {
   if (const Tree* const found = member(tree, names)) return *found;
   throw InputError(std::string("it has no ") + *names.begin());
}

std::vector<double> numbers_of(const Tree& node, const std::string& name) {
   std::vector<double> numbers;
   const auto take = [&](const Tree& item) {
      const std::optional<double> number = number_of(item);
      if (!number) throw InputError("its " + name + " is not a list of numbers");
      numbers.push_back(*number);
   };
   if (node.is_array()) std::for_each(node.begin(), node.end(), take);
   else take(node);
   return numbers;
}

cv::Mat matrix_of(const Tree& node, int rows, int columns, const std::string& name) {
   if (node.is_object()) {
      const auto side = [&](const char* key) { return number_of(required_member(node, {key})); };
      if (side("rows") != rows || side("cols") != columns) refuse_matrix(name, rows, columns);
      return matrix_of(required_member(node, {"data"}), rows, columns, name);
   }
   std::vector<double> all;
   if (node.is_array() && !node.empty() && node.front().is_array()) {
      if (node.size() != std::size_t(rows)) refuse_matrix(name, rows, columns);
      for (const Tree& row : node) {
         const std::vector<double> numbers = row.is_array() ? numbers_of(row, name) : std::vector<double>();
         if (numbers.size() != std::size_t(columns)) refuse_matrix(name, rows, columns);
         all.insert(all.end(), numbers.begin(), numbers.end());
      }
   } else {
      all = numbers_of(node, name);
      if (all.size() != std::size_t(rows) * std::size_t(columns)) refuse_matrix(name, rows, columns);
   }
   return cv::Mat(all, true).reshape(1, rows);
}

std::string word_at(const Tree& tree, const char* name) {
   const Tree* const found = member(tree, {name});
   return found != nullptr && found->is_string() ? found->get<std::string>() : "";
}

int side_of(double side, const std::string& name) {
   constexpr double kLargest = 65536;
   if (side >= 1 && side <= kLargest && side == std::floor(side)) return int(side);
   throw InputError("its " + name + " is not a number of pixels");
}

Lens lens_of_word(const std::string& word) {
   if (word.empty()) return Lens::unsaid;
   for (const char* const radial : {"plumb_bob", "rational_polynomial", "radtan", "radial-tangential"})
      if (word == radial) return Lens::radial;
   for (const char* const fisheye : {"equidistant", "fisheye"})
      if (word == fisheye) return Lens::fisheye;
   throw InputError("its distortion_model is " + shown_word(word) +
                    ", but only plumb_bob, rational_polynomial and radtan, k1 k2 p1 p2 ..., and equidistant and "
                    "fisheye, k1 k2 k3 k4, are known");
}

cv::Mat distortion_of(const std::vector<double>& coefficients, Lens lens, const std::string& name) {
   if (coefficients.empty()) return {};
   const bool fisheye = lens == Lens::fisheye;
   const std::vector<std::size_t> counts =
       fisheye ? std::vector<std::size_t>{4} : std::vector<std::size_t>{4, 5, 8, 12, 14};
   if (std::find(counts.begin(), counts.end(), coefficients.size()) == counts.end())
      throw InputError("its " + name + " has " + std::to_string(coefficients.size()) + " coefficients but must have " +
                       (fisheye ? "4, as the fisheye model" : "4, 5, 8, 12 or 14"));
   return cv::Mat(coefficients, true).reshape(1, 1);
}

}  // namespace stereo::app
