// SPDX-License-Identifier: Apache-2.0
#include "program/evaluation/truth.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <sstream>
#include <vector>

namespace stereo::app {

TruthScore score_against_truth(const DisparityMap& map, const MapGeometry& geometry, const DisparityImage& truth,
                               const GrayImage& visible) {
   const int first = geometry.first_column;
   const auto steps = float(map.steps_per_pixel());
   TruthScore result;
   for (int y = 0; y < map.height; ++y)
      for (int x = 0; x < map.width; ++x) {
         const float wanted = truth.at(first + x, y);
         if (visible.at(first + x, y) == 0 || !has_disparity(wanted)) continue;
         if (!map.has_value_at(x, y)) {
            ++result.invalid;
            continue;
         }
         const float found = float(geometry.min_disparity) + float(map.at(x, y)) / steps;
         ++result.compared;
         result.bad += std::abs(found - wanted) > float(kBadPixelTolerance) ? 1 : 0;
      }
   return result;
}

std::string range_remark(const std::string& name, const DisparityImage& truth, DisparityRange range) {
   std::vector<float> known;
   std::copy_if(truth.px.begin(), truth.px.end(), std::back_inserter(known), has_disparity);
   const auto first = float(range.first), last = float(range.first + range.count - 1);
   // Half a pixel further still has its nearest whole pixel in the range.
   const auto outside =
       std::count_if(known.begin(), known.end(), [&](float px) { return px < first - 0.5F || px > last + 0.5F; });
   if (2 * std::size_t(outside) <= known.size()) return "";
   const auto [smallest, largest] = std::minmax_element(known.begin(), known.end());
   std::ostringstream text;
   text << name << " searches disparities of " << range.first << " ... " << range.first + range.count - 1 << " px, but "
        << 100 * outside / std::ptrdiff_t(known.size()) << " % of the ground truth, " << *smallest << " ... "
        << *largest << " px, lies outside; check the scale of the truth";
   return text.str();
}

std::string bad_remark(const std::string& name, double bad, double compared) {
   if (compared == 0 || bad < 0.9 * compared) return "";
   std::ostringstream text;
   text << std::floor(100 * bad / compared) << " % of the disparities that " << name << " found are off by more than "
        << kBadPixelTolerance << " px; check that the truth and its scale belong to these images";
   return text.str();
}

}  // namespace stereo::app
