// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "raster.hpp"
#include "row_buffer.hpp"

namespace stereo {

/// The x-Sobel prefilter of P rows of one image. 2 clocks behind the columns.
template <const StereoConfig& C>
struct XSobel {
   static constexpr int kClocks = 2;
   static constexpr int kPixels = C.pixels_per_clock;
   static constexpr int kRows = kPixels + 2;

   uint16_t column[3][kPixels];  ///< [age][p]: weighted sum of three rows, 0 ... 1020
   Feature<C> feature[kPixels];

   HLS_INLINE XSobel() {
      HLS_UNROLL
      for (int age = 0; age < 3; ++age) fill<uint16_t>(column[age], 0);
      fill<Feature<C>>(feature, 0);
   }

   /// move: `pixel` is a column, not a bubble. row_inside: its rows lie in the image; column_inside: [age], the columns
   /// that have come lie in it.
   template <class Inside>
   HLS_INLINE void clock(bool move, const uint8_t (&pixel)[kRows], const bool (&row_inside)[kRows],
                         const Inside& column_inside) {
      HLS_UNROLL
      for (int p = 0; p < kPixels; ++p) {
         const int16_t slope = int16_t(column[0][p] - column[2][p]);
         const int16_t low = select<int16_t>(slope < -C.prefilter_cap, -C.prefilter_cap, slope);
         const int16_t clamped = select<int16_t>(low > C.prefilter_cap, C.prefilter_cap, low);
         const bool whole = column_inside[0] && column_inside[2];
         feature[p] = Feature<C>(select<int16_t>(whole, clamped, 0) + C.prefilter_cap);
         // Outside the image stands the row on the other side.
         const uint8_t above = select<uint8_t>(row_inside[p], pixel[p], pixel[p + 2]);
         const uint8_t below = select<uint8_t>(row_inside[p + 2], pixel[p + 2], pixel[p]);
         column[2][p] = select<uint16_t>(move, column[1][p], column[2][p]);
         column[1][p] = select<uint16_t>(move, column[0][p], column[1][p]);
         column[0][p] = select<uint16_t>(move, uint16_t(above + 2 * pixel[p + 1] + below), column[0][p]);
      }
   }
};

/// The census transforms of P rows of one image. 2 clocks behind the columns.
template <const StereoConfig& C>
struct Census {
   static constexpr int kClocks = 2;
   static constexpr int kPixels = C.pixels_per_clock;
   static constexpr int kRows = kPixels + 2 * C.transform_rows();
   static constexpr int kColumns = C.census_width_px;

   uint8_t column[kColumns][kRows];  ///< [age][row]; 0 outside the image
   Feature<C> feature[kPixels];

   HLS_INLINE Census() {
      HLS_UNROLL
      for (int age = 0; age < kColumns; ++age) fill<uint8_t>(column[age], 0);
      fill<Feature<C>>(feature, 0);
   }

   template <class Inside>
   HLS_INLINE void clock(bool move, const uint8_t (&pixel)[kRows], const bool (&row_inside)[kRows],
                         const Inside& column_inside) {
      HLS_UNROLL
      for (int p = 0; p < kPixels; ++p) feature[p] = transform(p, column_inside);
      HLS_UNROLL
      for (int row = 0; row < kRows; ++row) {
         HLS_UNROLL
         for (int age = kColumns - 1; age > 0; --age)
            column[age][row] = select<uint8_t>(move, column[age - 1][row], column[age][row]);
         column[0][row] = select<uint8_t>(move, select<uint8_t>(row_inside[row], pixel[row], 0), column[0][row]);
      }
   }

  private:
   template <class Inside>
   HLS_INLINE Feature<C> transform(int p, const Inside& column_inside) const {
      const uint8_t centre = column[kColumns / 2][p + C.transform_rows()];
      Feature<C> bits = 0;
      int bit = 0;
      HLS_UNROLL
      for (int age = 0; age < kColumns; ++age) {
         HLS_UNROLL
         for (int row = 0; row < C.census_height_px; ++row) {
            if (age == kColumns / 2 && row == C.transform_rows()) continue;
            const bool larger = column_inside[age] && column[age][p + row] > centre;
            bits |= Feature<C>(Feature<C>(larger) << bit++);
         }
      }
      return bits;
   }
};

/// Replaces the pixels of both images by what is compared: filtered pixels or census transforms. 6 clocks; the groups
/// come out transform_groups() rows and transform_columns() columns later. Memory: two times W x 8 x kStored bits.
template <const StereoConfig& C>
struct Transform {
   static constexpr int kPixels = C.pixels_per_clock;
   static constexpr int kAround = C.transform_rows();
   static constexpr int kColumns = C.transform_columns();
   static constexpr int kRows = kPixels + 2 * kAround;
   static constexpr int kStored = C.transform_groups() * kPixels + kAround;
   static constexpr int kClocks = 6;
   template <int Number>
   using Rows = RowBuffer<8, kPixels, kStored, C.width_px, Number>;
   using Filter = std::conditional_t<C.cost == Cost::census, Census<C>, XSobel<C>>;
   using Counter = RasterCounter<C.width_px, C.row_groups(), C.transform_groups(), true>;

   /// What travels beside the pixels.
   struct Place {
      uint16_t column = 0;
      bool row_inside[kRows];                ///< [r]: the row is one of the image
      bool column_inside[2 * kColumns + 1];  ///< [age]: the column is of the same row as the centre's, kColumns old
      bool start_of_frame = false;           ///< the centre is the first of a frame
      bool valid = false;

      HLS_INLINE Place() {
         fill(row_inside, false);
         fill(column_inside, false);
      }
   };

   uint8_t left[kPixels], right[kPixels];  // clock 1
   bool valid = false;
   Counter counter;
   Rows<memory_numbers::kLeftPixels> left_rows;  // clocks 2 and 3
   Rows<memory_numbers::kRightPixels> right_rows;
   Place read, ready;
   uint16_t write_column = 0;
   uint8_t left_column[kRows], right_column[kRows];  // clock 4
   Place columns;
   Filter left_filter, right_filter;  // clocks 5 and 6
   Place filtering, filtered;

   template <class Source>
   HLS_INLINE explicit Transform(Source& memories) : left_rows(memories), right_rows(memories) {
      fill<uint8_t>(left, 0);
      fill<uint8_t>(right, 0);
      fill<uint8_t>(left_column, 0);
      fill<uint8_t>(right_column, 0);
   }

   HLS_INLINE FeatureGroup<C> output() const {
      FeatureGroup<C> out;
      const Filter& search = C.reference == Reference::right ? left_filter : right_filter;
      const Filter& reference = C.reference == Reference::right ? right_filter : left_filter;
      HLS_UNROLL
      for (int p = 0; p < kPixels; ++p) {
         out.search[p] = search.feature[p];
         out.reference[p] = reference.feature[p];
      }
      out.start_of_frame = filtered.start_of_frame;
      out.valid = filtered.valid;
      return out;
   }

   HLS_INLINE void clock(const StereoInput& in) {
      copy(filtered, filtering);
      left_filter.clock(columns.valid, left_column, columns.row_inside, filtering.column_inside);
      right_filter.clock(columns.valid, right_column, columns.row_inside, filtering.column_inside);
      copy(filtering, columns);
      HLS_UNROLL
      for (int row = 0; row < kRows; ++row) {
         left_column[row] = left_rows.row(row);
         right_column[row] = right_rows.row(row);
      }
      copy(columns, ready);
      left_rows.clock(left, counter.column, ready.valid, write_column);
      right_rows.clock(right, counter.column, ready.valid, write_column);
      write_column = select<uint16_t>(ready.valid, ready.column, write_column);
      copy(ready, read);
      find_place();
      counter.clock(in.valid, in.start_of_frame);
      valid = in.valid;
      HLS_UNROLL
      for (int p = 0; p < kPixels; ++p) {
         left[p] = in.left[p];
         right[p] = in.right[p];
      }
   }

  private:
   /// Row r of the column shows row (group - transform_groups) * P - transform_rows + r of the image.
   static constexpr int first_group(int r) { return (kStored - r + kPixels - 1) / kPixels; }
   static constexpr int last_group(int r) { return (C.height_px - 1 + kStored - r) / kPixels; }

   HLS_INLINE void find_place() {
      read.valid = valid;
      read.column = counter.column;
      HLS_UNROLL
      for (int r = 0; r < kRows; ++r)
         read.row_inside[r] = counter.group >= first_group(r) && counter.group <= last_group(r);
      HLS_UNROLL
      for (int age = 0; age <= 2 * kColumns; ++age)
         read.column_inside[age] = (counter.column >= age) == (counter.column >= kColumns);
      read.start_of_frame = counter.group == C.transform_groups() && counter.column == kColumns;
   }

   static HLS_INLINE void copy(Place& to, const Place& from) {
      to.column = from.column;
      HLS_UNROLL
      for (int r = 0; r < kRows; ++r) to.row_inside[r] = from.row_inside[r];
      HLS_UNROLL
      for (int age = 0; age <= 2 * kColumns; ++age) to.column_inside[age] = from.column_inside[age];
      to.start_of_frame = from.start_of_frame;
      to.valid = from.valid;
   }
};

}  // namespace stereo
