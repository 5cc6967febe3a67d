// SPDX-License-Identifier: Apache-2.0
#include "program/io/overview.hpp"

#include <algorithm>
#include <opencv2/imgproc.hpp>

#include "program/io/opencv_images.hpp"

namespace stereo::app {
namespace {

constexpr int kReadableWidth = 224;   ///< captions fit above a panel of this width
constexpr int kLargestHeight = 1024;  ///< that enlarging may reach
const cv::Scalar kPaper(255, 255, 255), kInk(40, 40, 40), kNothing(32, 32, 32);

/// Lengths of the page in pixels. Captions grow with large images.
struct Layout {
   explicit Layout(const GrayImage& image)
       : zoom(std::max(1, std::min((kReadableWidth + image.width - 1) / image.width, kLargestHeight / image.height))),
         panel(image.width * zoom, image.height * zoom),
         text(std::max(1.0, panel.width / 480.0)) {}

   int scaled(double length) const { return int(length * text); }
   int gap() const { return scaled(6); }
   int caption() const { return scaled(22); }
   int bar() const { return scaled(12); }
   int bar_labels() const { return scaled(48); }
   cv::Size page() const {
      return {3 * panel.width + 5 * gap() + bar() + bar_labels(), panel.height + caption() + gap()};
   }
   cv::Rect panel_at(int number) const { return {cv::Point(gap() + number * (panel.width + gap()), caption()), panel}; }

   int zoom;
   cv::Size panel;
   double text;
};

cv::Mat enlarged(const cv::Mat& image, int zoom) {
   cv::Mat result;
   cv::resize(image, result, {}, zoom, zoom, cv::INTER_NEAREST);
   return result;
}

cv::Mat enlarged_gray(GrayImage image, int zoom) {
   cv::Mat color;
   cv::cvtColor(as_mat(image), color, cv::COLOR_GRAY2BGR);
   return enlarged(color, zoom);
}

void write(cv::Mat& page, const Layout& layout, const std::string& text, int x, int base_line) {
   cv::putText(page, text, {x, base_line}, cv::FONT_HERSHEY_SIMPLEX, 0.45 * layout.text, kInk,
               std::max(1, layout.scaled(1)), cv::LINE_AA);
}

/// The colours of all disparities from the smallest at the bottom to the largest at the top.
void draw_color_bar(cv::Mat& page, const Layout& layout, int min_disparity, int disparities) {
   const cv::Rect last = layout.panel_at(2);
   const cv::Rect bar(last.x + last.width + layout.gap(), last.y, layout.bar(), last.height);
   DisparityMap steps(1, bar.height);
   for (int y = 0; y < bar.height; ++y) steps.at(0, y) = uint16_t((bar.height - 1 - y) * disparities / bar.height);
   cv::resize(colored(steps, disparities), page(bar), bar.size(), 0, 0, cv::INTER_NEAREST);
   const int x = bar.x + bar.width + layout.scaled(4);
   write(page, layout, std::to_string(min_disparity + disparities - 1) + " px", x, bar.y + layout.scaled(10));
   write(page, layout, std::to_string(min_disparity), x, bar.y + bar.height - 1);
}

}  // namespace

std::string encode_overview_png(const ImagePair& pair, const DisparityMap& map, const MapGeometry& geometry) {
   const Layout layout(pair.right);
   cv::Mat page(layout.page(), CV_8UC3, kPaper);
   enlarged_gray(pair.left, layout.zoom).copyTo(page(layout.panel_at(0)));
   enlarged_gray(pair.right, layout.zoom).copyTo(page(layout.panel_at(1)));
   page(layout.panel_at(2)).setTo(kNothing);
   const cv::Mat color = enlarged(colored(map, geometry.disparities), layout.zoom);
   const cv::Point first_column(geometry.first_column * layout.zoom, 0);
   color.copyTo(page(cv::Rect(layout.panel_at(2).tl() + first_column, color.size())));
   const bool left = geometry.reference == Reference::left;
   const char* const captions[] = {left ? "left (reference)" : "left", left ? "right" : "right (reference)",
                                   "disparity"};
   for (int number = 0; number < 3; ++number)
      write(page, layout, captions[number], layout.panel_at(number).x, layout.scaled(15));
   draw_color_bar(page, layout, geometry.min_disparity, geometry.disparities);
   return encode(page);
}

}  // namespace stereo::app
