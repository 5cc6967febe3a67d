// SPDX-License-Identifier: Apache-2.0
#include "definition/block_matching/models.hpp"
#include "fuzz/memory_file.hpp"
#include "fuzz/targets.hpp"
#include "program/errors.hpp"
#include "program/evaluation/masks.hpp"
#include "program/io/images.hpp"
#include "program/io/overview.hpp"

namespace stereo::fuzz {
namespace {

constexpr std::size_t kMostPixels = 4096;  ///< that are matched: more only take time
constexpr int kWidth = 32, kHeight = 12;

/// As `stereo_hls match` does with a pair of any size.
void match_any_size(const ImagePair& pair) {
   const block_matching::Matching parameters{DisparityCount{4}, LeftRightThreshold{1}};
   if (map_width(pair.left.width, parameters) < 1) return;
   const DisparityMap map = match_fast(pair.left, pair.right, parameters);
   promise(map.width == map_width(pair.left.width, parameters) && map.height == pair.left.height,
           "a map has the size that follows from its images");
   for (const std::string& png :
        {app::encode_png(map), app::encode_color_png(map, parameters.disparities), app::encode_valid_png(map),
         app::encode_overview_png(pair, map, map_geometry(parameters, pair.left.width))})
      promise(!png.empty(), "a map can be written as a picture");
}

void fit(const ImagePair& pair, app::Fit how) {
   const ImagePair fitted = app::fit_pair(pair, kWidth, kHeight, how);
   promise(fitted.left.width == kWidth && fitted.left.height == kHeight && fitted.right.same_size(fitted.left),
           "a pair that was made to fit fits");
}

}  // namespace

bool image(std::string_view bytes) {
   const MemoryFile file(bytes);
   ImagePair pair;
   try {
      pair = app::load_pair(file.path(), file.path());
   } catch (const app::InputError& refusal) {
      check_refusal(refusal, file.path() + ": ");
      return false;
   }
   promise(pair.left == pair.right, "a file is always read alike");
   promise(pair.left.width >= 1 && pair.left.height >= 1, "an image has pixels");
   promise(pair.left.pixels.size() == std::size_t(pair.left.width) * std::size_t(pair.left.height),
           "an image has all its pixels");
   if (pair.left.pixels.size() > kMostPixels) return true;
   match_any_size(pair);
   fit(pair, app::Fit::resize);
   if (pair.left.width >= kWidth && pair.left.height >= kHeight) fit(pair, app::Fit::crop);
   promise(app::textureless_mask(pair.left).same_size(pair.left), "a mask has the size of its image");
   return true;
}

}  // namespace stereo::fuzz
