// SPDX-License-Identifier: Apache-2.0
// What the pictures of a disparity map hold.
#include "program/io/images.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <opencv2/imgcodecs.hpp>

#include "definition/block_matching/models.hpp"
#include "program/errors.hpp"
#include "program/io/exif.hpp"
#include "program/io/overview.hpp"

namespace stereo::app {
namespace {

cv::Mat decoded(const std::string& png) {
   return cv::imdecode(std::vector<uint8_t>(png.begin(), png.end()), cv::IMREAD_UNCHANGED);
}

const cv::Vec3b kBlack(0, 0, 0);

TEST(Images, DisparitiesAreGreyValues) {
   DisparityMap map(4, 2, 9);
   map.at(3, 1) = 255;
   map.valid_at(0, 0) = 0;
   const cv::Mat image = decoded(encode_png(map));
   ASSERT_EQ(image.type(), CV_8UC1);
   ASSERT_EQ(image.size(), cv::Size(4, 2));
   EXPECT_EQ(image.at<uint8_t>(1, 3), 255);
   EXPECT_EQ(image.at<uint8_t>(0, 0), 9) << "also where they are not valid";
}

TEST(Images, SixteenthsHave16Bits) {
   DisparityMap map(4, 2, 9, true);
   map.at(3, 1) = 255 * 16;
   const cv::Mat image = decoded(encode_png(map));
   ASSERT_EQ(image.type(), CV_16UC1);
   EXPECT_EQ(image.at<uint16_t>(1, 3), 4080);
   EXPECT_EQ(image.at<uint16_t>(0, 0), 9);
}

TEST(Images, ValidityIsBlackAndWhite) {
   DisparityMap map(4, 2, 9);
   map.valid_at(2, 1) = 0;
   const cv::Mat image = decoded(encode_valid_png(map));
   ASSERT_EQ(image.type(), CV_8UC1);
   EXPECT_EQ(image.at<uint8_t>(1, 2), 0);
   EXPECT_EQ(cv::countNonZero(image == 255), 7);
}

TEST(Images, InvalidPixelsHaveNoColour) {
   DisparityMap map(4, 2, 9);
   map.valid_at(2, 1) = 0;
   const cv::Mat image = decoded(encode_color_png(map, 16));
   ASSERT_EQ(image.type(), CV_8UC3);
   for (int y = 0; y < 2; ++y)
      for (int x = 0; x < 4; ++x) EXPECT_EQ(image.at<cv::Vec3b>(y, x) == kBlack, x == 2 && y == 1) << x << ' ' << y;
}

TEST(Images, ColoursAreThoseOfPixelsWhateverTheUnit) {
   DisparityMap pixels(8, 1), sixteenths(8, 1, 0, true);
   for (int x = 0; x < 8; ++x) {
      pixels.at(x, 0) = uint16_t(x);
      sixteenths.at(x, 0) = uint16_t(16 * x);
   }
   EXPECT_EQ(encode_color_png(pixels, 8), encode_color_png(sixteenths, 8));
}

TEST(Images, TheOverviewPutsTheMapWhereItBelongs) {
   const ImagePair pair{GrayImage(300, 200, 90), GrayImage(300, 200, 90)};
   const auto columns_of_the_map = [&pair](Reference reference) {
      const block_matching::Matching parameters{DisparityCount{60}, ReferenceImage{reference}};
      DisparityMap map(map_width(300, parameters), 200, 30);
      const cv::Mat page = decoded(encode_overview_png(pair, map, map_geometry(parameters, 300)));
      std::vector<int> columns;  // of colour, left of the colour bar
      for (int x = 600; x < 920; ++x) {
         const cv::Vec3b pixel = page.at<cv::Vec3b>(150, x);
         if (pixel[0] != pixel[1] || pixel[1] != pixel[2]) columns.push_back(x);
      }
      return columns;
   };
   const auto right = columns_of_the_map(Reference::right), left = columns_of_the_map(Reference::left);
   ASSERT_EQ(right.size(), 240u);
   ASSERT_EQ(left.size(), 240u);
   EXPECT_EQ(right.back() - right.front(), 239);
   EXPECT_EQ(left.front() - right.front(), 60);
}

using namespace std::string_literals;

std::string encoded(const std::string& ending) {
   GrayImage image(64, 48);
   for (std::size_t i = 0; i < image.pixels.size(); ++i) image.pixels[i] = uint8_t(i * i / 7);
   std::vector<uint8_t> bytes;
   cv::imencode(ending, cv::Mat(48, 64, CV_8UC1, image.pixels.data()), bytes);
   return {bytes.begin(), bytes.end()};
}

/// What load_gray says of a file, or nothing.
std::string refusal(const std::string& bytes, const std::string& ending) {
   const auto path = std::filesystem::temp_directory_path() / ("images_test_" + std::to_string(getpid()) + ending);
   std::ofstream(path, std::ios::binary) << bytes;
   std::string sentence;
   try {
      load_gray(path.string());
   } catch (const InputError& problem) {
      sentence = problem.what();
   }
   std::filesystem::remove(path);
   return sentence;
}

TEST(Images, BrokenOffOnesAreRefused) {
   for (const std::string ending : {".jpg", ".png", ".bmp", ".tif", ".pgm", ".webp", ".jp2"}) {
      const std::string whole = encoded(ending);
      EXPECT_EQ(refusal(whole, ending), "") << ending;
      for (const double part : {0.4, 0.6, 0.8, 0.95})
         EXPECT_NE(refusal(whole.substr(0, std::size_t(part * double(whole.size()))), ending), "") << ending << part;
      // A TIFF file of OpenCV's ends with an offset of 0, which nothing needs.
      if (ending == ".tif") continue;
      EXPECT_NE(refusal(whole.substr(0, whole.size() - 1), ending), "") << ending;
   }
}

TEST(Images, DamagedJpegIsRefused) {
   const std::string whole = encoded(".jpg");
   EXPECT_NE(refusal(whole.substr(0, whole.size() / 2) + "\xff\xd9", ".jpg").find("truncated or damaged"),
             std::string::npos);
}

TEST(Images, DicomIsRefused) {
   for (const std::string& end : {""s, "\x7f"s, std::string(500, '\1')})
      EXPECT_NE(refusal(std::string(128, '\0') + "DICM" + end, ".png").find("is a DICOM file"), std::string::npos);
}

/// A directory with the orientation alone, in either byte order.
std::string exif(char orientation, bool little_endian) {
   if (little_endian) return "II*\0\x08\0\0\0\1\0\x12\1\3\0\1\0\0\0"s + orientation + "\0\0\0\0\0\0\0"s;
   return "MM\0*\0\0\0\x08\0\1\1\x12\0\3\0\0\0\1\0"s + orientation + "\0\0\0\0\0\0"s;
}

/// A file of each format with EXIF data.
std::string with_exif(const std::string& ending, const std::string& data) {
   std::string bytes = encoded(ending);
   const auto big = [](std::size_t value, int count) {
      std::string number;
      for (int i = count - 1; i >= 0; --i) number += char(value >> (8 * i));
      return number;
   };
   if (ending == ".jpg") return bytes.insert(2, "\xff\xe1" + big(data.size() + 8, 2) + "Exif\0\0"s + data);
   if (ending == ".png") {
      const std::size_t behind_header = 33;
      uint32_t crc = 0xffffffff;
      for (const char c : "eXIf" + data) {
         crc ^= uint8_t(c);
         for (int i = 0; i < 8; ++i) crc = (crc & 1) != 0 ? crc >> 1 ^ 0xedb88320 : crc >> 1;
      }
      return bytes.insert(behind_header, big(data.size(), 4) + "eXIf" + data + big(~crc, 4));
   }
   return bytes;
}

TEST(Images, TurnedOnesAreRefusedWhateverTheFormat) {
   for (const bool little_endian : {true, false})
      for (char orientation = 1; orientation <= 8; ++orientation) {
         const std::string data = exif(orientation, little_endian);
         EXPECT_EQ(exif_orientation(data), orientation) << "a TIFF file";
         for (const std::string ending : {".jpg", ".png"}) {
            const std::string file = with_exif(ending, data), said = refusal(file, ending);
            EXPECT_EQ(exif_orientation(file), orientation) << ending;
            EXPECT_EQ(said.find("orientation " + std::to_string(orientation)) != std::string::npos, orientation != 1)
                << ending << ": " << said;
         }
      }
}

TEST(Images, OrientationOfATiffFileIsRefused) {
   // OpenCV's files end with their directory; one entry more with the tag 274, in the order of tags.
   std::string file = encoded(".tif");
   ASSERT_EQ(exif_orientation(file), 1);
   ASSERT_EQ(file.substr(0, 2), "II");
   const auto at = [&file](std::size_t offset) { return std::size_t(uint8_t(file[offset])); };
   const std::size_t directory = at(4) | at(5) << 8 | at(6) << 16, entries = at(directory);
   std::string moved = file.substr(directory + 2, 12 * entries);
   std::size_t place = 0;
   while (place < moved.size() && uint8_t(moved[place]) + 256 * uint8_t(moved[place + 1]) < 274) place += 12;
   moved.insert(place, "\x12\1\3\0\1\0\0\0\6\0\0\0"s);
   const std::size_t new_directory = file.size() + file.size() % 2;
   file.resize(new_directory, '\0');
   file += char(entries + 1) + "\0"s + moved + "\0\0\0\0"s;
   for (int i = 0; i < 4; ++i) file[4 + std::size_t(i)] = char(new_directory >> (8 * i));
   EXPECT_EQ(exif_orientation(file), 6);
   EXPECT_NE(refusal(file, ".tif").find("orientation 6"), std::string::npos) << refusal(file, ".tif");
}

TEST(Images, DamagedExifIsNone) {
   const std::string file = with_exif(".jpg", exif(6, true));
   for (std::size_t length = 0; length < 60; ++length) {
      const int orientation = exif_orientation(file.substr(0, length));
      EXPECT_TRUE(orientation == 1 || orientation == 6) << length;
   }
   EXPECT_EQ(exif_orientation(exif(9, true)), 1);
   EXPECT_EQ(exif_orientation(exif(0, false)), 1);
   EXPECT_EQ(exif_orientation(""), 1);
   EXPECT_EQ(exif_orientation("II*\0\xff\xff\xff\xff"s), 1);
}

}  // namespace
}  // namespace stereo::app
