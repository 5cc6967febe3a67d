// SPDX-License-Identifier: Apache-2.0
#include "program/io/match_files.hpp"

#include <algorithm>
#include <bit>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <opencv2/core.hpp>

#include "program/commands/options_json.hpp"
#include "program/errors.hpp"
#include "program/io/disparity_files.hpp"
#include "program/io/opencv_images.hpp"

namespace stereo::app {
namespace {

namespace fs = std::filesystem;

constexpr double kKittiScale = 256, kKittiLargest = 65535;

/// What match.json says of the map.
struct Facts {
   Reference reference;
   int width, height, map_width, first_column, min_disparity;
   double steps_per_px;
   std::optional<std::vector<std::string>> files;  ///< none: of a version that did not list them

   /// Whether a file beside the map is of the same run.
   bool lists(const char* name) const {
      return !files || std::find(files->begin(), files->end(), name) != files->end();
   }
};

std::optional<Facts> facts_beside(const fs::path& path) {
   std::ifstream file(path.parent_path() / kFactsName);
   const auto json = nlohmann::json::parse(file, nullptr, false);
   if (!json.is_object() || json.value("format", nlohmann::json()) != kFactsFormat) return std::nullopt;
   try {
      return Facts{
          json.at("reference") == word_of(Reference::left) ? Reference::left : Reference::right,
          json.at("width_px"),
          json.at("height_px"),
          json.at("output_width_px"),
          json.at("output_first_column"),
          json.value("min_disparity", 0),
          json.at("disparity_steps_per_px"),
          json.contains("files") ? std::optional(json["files"].get<std::vector<std::string>>()) : std::nullopt};
   } catch (const nlohmann::json::exception&) {
      return std::nullopt;
   }
}

/// The map itself, which has its own columns and counts from the smallest disparity on.
OwnMap own_map(const std::string& option, const fs::path& path, const Facts& facts, double scale) {
   const DisparityImage map = load_disparities(option, path.string(), {.scale = scale, .zero_is_known = true}).image;
   if (map.width != facts.map_width || map.height != facts.height || facts.first_column < 0 ||
       facts.first_column + map.width > facts.width)
      throw InputError(option + " " + path.string() + ": is not the map that " + kFactsName + " beside it describes");
   const fs::path valid_path = path.parent_path() / kValidName;
   const bool checked = facts.lists(kValidName) && fs::is_regular_file(valid_path);
   const GrayImage valid = checked ? load_gray(valid_path.string()) : GrayImage(map.width, map.height, 255);
   if (!map.same_size(valid))
      throw InputError(option + " " + path.string() + ": " + kValidName + " beside it is of another size");
   const fs::path filled_path = path.parent_path() / kFilledName;
   const bool fills = facts.lists(kFilledName) && fs::is_regular_file(filled_path);
   const GrayImage filled = fills ? load_gray(filled_path.string()) : GrayImage(map.width, map.height);
   if (!map.same_size(filled))
      throw InputError(option + " " + path.string() + ": " + kFilledName + " beside it is of another size");
   OwnMap own{facts.reference, DisparityImage(facts.width, facts.height), scale};
   for (int y = 0; y < map.height; ++y)
      for (int x = 0; x < map.width; ++x)
         if (valid.at(x, y) != 0 || filled.at(x, y) != 0)
            own.image.at(facts.first_column + x, y) = float(facts.min_disparity) + map.at(x, y);
   return own;
}

}  // namespace

std::optional<OwnMap> load_own_map(const std::string& option, const std::string& path, std::optional<double> scale) {
   const std::string name = fs::path(path).filename().string();
   const auto facts = facts_beside(path);
   if (!facts) return std::nullopt;
   if (name == kMapName) return own_map(option, path, *facts, scale.value_or(facts->steps_per_px));
   if (name != kPfmName && name != kKittiName) return std::nullopt;
   LoadedDisparities loaded = load_disparities(option, path, {.scale = scale});
   return OwnMap{facts->reference, std::move(loaded.image), loaded.scale};
}

std::string encode_kitti_png(const DisparityImage& image) {
   cv::Mat_<uint16_t> mat(image.height, image.width);
   std::transform(image.px.begin(), image.px.end(), mat.begin(), [](float px) {
      const double value = std::round(kKittiScale * double(px));
      return value >= 0 && value <= kKittiLargest ? uint16_t(std::max(value, 1.0)) : uint16_t(0);
   });
   return encode(mat);
}

int beyond_kitti(const DisparityImage& image) {
   return int(std::count_if(image.px.begin(), image.px.end(),
                            [](float px) { return px < 0 || std::round(kKittiScale * double(px)) > kKittiLargest; }));
}

std::string encode_pfm(const DisparityImage& image) {
   std::string bytes = "Pf\n" + std::to_string(image.width) + " " + std::to_string(image.height) + "\n-1\n";
   for (int y = image.height - 1; y >= 0; --y)
      for (int x = 0; x < image.width; ++x) {
         const float px = image.at(x, y);
         const auto word = std::bit_cast<uint32_t>(has_disparity(px) ? px : std::numeric_limits<float>::infinity());
         for (int i = 0; i < 4; ++i) bytes += char(uint8_t(word >> (8 * i)));
      }
   return bytes;
}

}  // namespace stereo::app
