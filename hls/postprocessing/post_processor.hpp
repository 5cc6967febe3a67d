// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "postprocessing/fill.hpp"
#include "postprocessing/support.hpp"
#include "support/optional_block.hpp"
#include "winner/median.hpp"

namespace stereo {

/// Whether a configuration has any stage of the post-processing but the median.
template <const auto& C>
inline constexpr bool kPostProcesses = [] {
   if constexpr (requires { C.has_post_processing(); }) return C.has_post_processing();
   else return false;
}();

/// The post-processing behind the checks of any family: what makes the map of the winners. Each stage may be absent,
/// but not all of them.
///
///              winners
///                 |
///   clocks     support        10     filter and confidence, some rows and 6 columns later
///              fill           10     holes, a row later
///              median         11     a row and a column later
///                 |
///            a column of the map
template <const auto& C>
struct PostProcessor {
   using SupportBlock = Optional<C.has_support_filter(), Support<C>>;
   using FillBlock = Optional<C.fill_holes, Fill<C>>;
   using MedianBlock = Optional<C.median, Median<C>>;
   static constexpr int kClocks = SupportBlock::kClocks + FillBlock::kClocks + MedianBlock::kClocks;
   static constexpr int kLagGroups = SupportBlock::kLagGroups + FillBlock::kLagGroups + MedianBlock::kLagGroups;
   static constexpr int kMemories = SupportBlock::kMemories + FillBlock::kMemories + MedianBlock::kMemories;

   SupportBlock support;
   FillBlock fill;
   MedianBlock median;

   template <class Source, int First>
   HLS_INLINE PostProcessor(Source& memories, MemoryId<First> number)
       : support(memories, number),
         fill(memories, MemoryId<First + SupportBlock::kMemories>()),
         median(memories, MemoryId<First + SupportBlock::kMemories + FillBlock::kMemories>()) {}

   template <class Visitor>
   HLS_INLINE void groups(Visitor& visit) {
      if constexpr (C.has_support_filter()) visit.block("support", support);
      if constexpr (C.fill_holes) visit.block(fill_name(), fill);
      if constexpr (C.median) visit.block("median", median);
   }

   HLS_INLINE MapGroup<C> group() const {
      if constexpr (C.median) return median.out;
      else return map_group<C>(shown());
   }

   /// size: of the map, as the blocks of the core have it.
   template <const auto& W, class Size, class Settings = NoSettings>
   HLS_INLINE void clock(const Winners<W>& in, const Size& size, const Settings& settings = Settings()) {
      clock(map_column<C>(in), size, settings);
   }
   template <class Size, class Settings = NoSettings>
   HLS_INLINE void clock(const MapColumn<C>& column, const Size& size, const Settings& settings = Settings()) {
      if constexpr (C.median && C.has_post_processing()) median.clock(shown(), size);
      else if constexpr (C.median) median.clock(column, size);
      if constexpr (C.fill_holes && C.has_support_filter()) fill.clock(support.out, size.map);
      else if constexpr (C.fill_holes) fill.clock(column, size.map);
      if constexpr (C.has_support_filter()) support.clock(column, size.map, settings);
   }

  private:
   static constexpr const char* fill_name() {
      if constexpr (requires { C.kHolesBlock; }) return C.kHolesBlock;
      else return "fill";
   }
   HLS_INLINE const MapColumn<C>& shown() const {
      if constexpr (C.fill_holes) return fill.out;
      else return support.out;
   }
};

}  // namespace stereo
