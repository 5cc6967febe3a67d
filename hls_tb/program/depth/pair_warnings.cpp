// SPDX-License-Identifier: Apache-2.0
#include "program/depth/pair_warnings.hpp"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace stereo::app {
namespace {

constexpr double kSlack = 1;             ///< pixels by which a feature may lie outside of a range
constexpr double kMostBelong = 0.2;      ///< share of features in the range of an exchanged pair, or less
constexpr double kFewestMirrored = 0.6;  ///< share of them in the mirrored range, or more
constexpr double kFewestOutside = 0.05;  ///< share of them that a range leaves out
constexpr int kFewestFeatures = 10;      ///< that say something about it
constexpr double kManyAtLast = 0.02;     ///< share of the pixels at the last disparity
constexpr double kMoreThanBefore = 2.5;  ///< times as many as at the two before

double median_of(std::vector<double> values) {
   const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
   std::nth_element(values.begin(), middle, values.end());
   return *middle;
}

/// Of the features whose rows agree, one behind the other.
std::vector<double> disparities_of(const std::vector<FeatureOffset>& features) {
   std::vector<double> disparities;
   for (const FeatureOffset& feature : features)
      if (std::abs(feature.down_px) <= 1.5 * kLargestVerticalOffset) disparities.push_back(feature.right_px);
   return disparities;
}

struct Searched {
   int first, last;
   bool has(double disparity) const { return disparity >= first - kSlack && disparity <= last + kSlack; }
};

std::string exchanged_warning(const std::vector<double>& disparities, Searched searched) {
   const auto belong = std::count_if(disparities.begin(), disparities.end(), [&](double d) { return searched.has(d); });
   const auto mirrored = std::count_if(disparities.begin(), disparities.end(),
                                       [&](double d) { return !searched.has(d) && searched.has(-d); });
   const auto all = double(disparities.size());
   if (double(belong) > kMostBelong * all || double(mirrored) < kFewestMirrored * all) return "";
   std::ostringstream text;
   text << "warning: left and right look exchanged: " << mirrored << " of " << disparities.size()
        << " matching features lie further left in the left image than in the right one\n";
   return text.str();
}

std::string range_warning(const std::vector<double>& disparities, Searched searched) {
   std::vector<double> above, below;
   for (const double d : disparities) {
      if (d > searched.last + kSlack) above.push_back(d);
      if (d < searched.first - kSlack) below.push_back(d);
   }
   const bool too_short = above.size() >= below.size();
   const std::vector<double>& outside = too_short ? above : below;
   if (outside.size() < kFewestFeatures || double(outside.size()) < kFewestOutside * double(disparities.size()))
      return "";
   std::ostringstream text;
   text << "warning: the range of disparities, " << searched.first << " ... " << searched.last
        << " px, looks too short: " << outside.size() << " of " << disparities.size() << " matching features lie "
        << (too_short ? "above" : "below") << " it, by the median at " << std::fixed << std::setprecision(0)
        << median_of(outside) << " px; see --set " << (too_short ? "disparities" : "min_disparity") << "\n";
   return text.str();
}

}  // namespace

std::optional<VerticalOffset> vertical_offset(const std::vector<FeatureOffset>& features) {
   if (features.empty()) return std::nullopt;
   std::vector<double> rows;
   for (const FeatureOffset& feature : features) rows.push_back(std::abs(feature.down_px));
   return VerticalOffset{median_of(rows), int(rows.size())};
}

std::string pair_warning(const ImagePair& pair, const MapGeometry& geometry) {
   const std::vector<FeatureOffset> features = matched_features(pair);
   const std::optional<VerticalOffset> offset = vertical_offset(features);
   if (!offset) return "";
   if (offset->median_px > kLargestVerticalOffset) {
      std::ostringstream text;
      text << "warning: the images do not look rectified: " << offset->features << " matching features lie "
           << std::fixed << std::setprecision(1) << offset->median_px
           << " rows apart (median), and block matching only looks along a row\n";
      return text.str();
   }
   const std::vector<double> disparities = disparities_of(features);
   const Searched searched{geometry.min_disparity, geometry.min_disparity + geometry.disparities - 1};
   const std::string exchanged = exchanged_warning(disparities, searched);
   return exchanged.empty() ? range_warning(disparities, searched) : exchanged;
}

std::string last_disparity_warning(const DisparityMap& map, const MapGeometry& geometry) {
   constexpr int kFewestDisparities = 16, kFewestPixels = 1000;  // of fewer, one holds many pixels anyway
   if (geometry.disparities < kFewestDisparities) return "";
   std::vector<double> pixels(std::size_t(geometry.disparities), 0);
   double all = 0;
   for (int y = 0; y < map.height; ++y)
      for (int x = 0; x < map.width; ++x) {
         if (!map.valid_at(x, y)) continue;
         // A fraction of a pixel belongs to the nearest disparity.
         const int step = (map.at(x, y) + map.steps_per_pixel() / 2) / map.steps_per_pixel();
         ++pixels[std::size_t(std::min(step, geometry.disparities - 1))];
         ++all;
      }
   const double last = pixels.back(), before = (pixels[pixels.size() - 2] + pixels[pixels.size() - 3]) / 2;
   if (last < kManyAtLast * all || last < kMoreThanBefore * before || all < kFewestPixels) return "";
   std::ostringstream text;
   text << "warning: the range of disparities looks too short: " << std::fixed << std::setprecision(1)
        << 100 * last / all << " % of the pixels have the last disparity of the range, "
        << geometry.min_disparity + geometry.disparities - 1 << " px; see --set disparities\n";
   return text.str();
}

}  // namespace stereo::app
