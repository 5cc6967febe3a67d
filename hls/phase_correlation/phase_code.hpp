// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "frontend/features.hpp"
#include "phase_correlation/row_filter.hpp"

namespace stereo::phase_correlation {

/// The phase codes of one image: the filters of each scale, then its six bits, all scales for the same pixel. kClocks
/// clocks behind the columns of pixels. Scales from `Scale` on.
template <const auto& C, int Scale = 0>
struct PhaseCode {
   using Column = ColumnFilter<C, Scale>;
   using Row = RowFilter<C, Scale>;
   using Next = PhaseCode<C, Scale + 1>;
   static constexpr int kClocks = Column::kClocks + Row::kClocks + 1;
   /// Columns that the largest scale waits for longer.
   static constexpr int kWaits = C.largest_reach().after - C.reach(Scale).after;

   Column along_column;
   Row along_row;
   uint8_t earlier[kWaits > 0 ? kWaits : 1];  ///< signs of the columns before
   uint8_t bits;                              ///< 0 where the filters reach outside of the image
   Next next;

   HLS_INLINE PhaseCode() { start(*this); }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("column", along_column);
      visit("row", along_row);
      visit("earlier", earlier);
      visit("bits", bits);
      visit("next", next);
   }

   HLS_INLINE Feature<C> code() const {
      return Feature<C>(Feature<C>(bits) << (CodeConfig::kBitsOfScale * Scale)) | next.code();
   }

   /// tags[j]: beside what the filters have made in their clock j.
   template <class Tag>
   HLS_INLINE void clock(const Pixel<C> (&column)[Column::kRows], const Tag (&tags)[kClocks]) {
      next.clock(column, tags);
      const Tag& tag = tags[kClocks - 2];
      const uint8_t shown = kWaits > 0 ? earlier[kWaits > 0 ? kWaits - 1 : 0] : along_row.signs;
      bits = select<uint8_t>(tag.inside[Scale], shown, 0);
      if constexpr (kWaits > 0) {
         HLS_UNROLL
         for (int i = kWaits - 1; i > 0; --i) earlier[i] = select<uint8_t>(tag.valid, earlier[i - 1], earlier[i]);
         earlier[0] = select<uint8_t>(tag.valid, along_row.signs, earlier[0]);
      }
      along_row.clock(along_column.response, tags + Column::kClocks - 1);
      along_column.clock(column);
   }
};

/// Behind the last scale.
template <const auto& C, int Scale>
   requires(Scale == C.scales)
struct PhaseCode<C, Scale> {
   template <class Visitor>
   HLS_INLINE void registers(Visitor&) {}

   HLS_INLINE Feature<C> code() const { return 0; }
   template <class Column, class Tags>
   HLS_INLINE void clock(const Column&, const Tags&) {}
};

}  // namespace stereo::phase_correlation
