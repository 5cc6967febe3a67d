// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>
#include <vector>

#include "block_matching/core.hpp"
#include "definition/block_matching/reference_model.hpp"

namespace stereo::test {

/// What the stages of a core showed of one frame, as the reference model has it: of a left reference, the mirror image.
struct Stages {
   CostVolume columns, sums;
};

/// The values of `Count` disparities that one stage shows, in the order in which it shows them.
template <const block_matching::Config& C, int Count>
struct StageValues {
   static constexpr int kPixels = C.pixels_per_clock;
   std::vector<int> values;  ///< [record][lane][disparity]

   template <class Value>
   void append(const Value (&shown)[kPixels][Count]) {
      for (const auto& lane : shown)
         for (const Value value : lane) values.push_back(int(value));
   }
   /// Puts them where they belong, the disparities from `first` on; `above` groups of rows come before the image.
   void place(int above, int first, CostVolume& volume) const {
      std::size_t i = std::size_t(above * kPixels * volume.width * Count);
      if (values.size() < i + std::size_t(volume.height * volume.width * Count))
         throw std::runtime_error("a stage showed only " + std::to_string(values.size()) + " values");
      for (int y = 0; y < volume.height; y += kPixels)
         for (int column = 0; column < volume.width; ++column) {
            const int x = C.reference == Reference::right ? column : volume.width - 1 - column;
            for (int p = 0; p < kPixels; ++p)
               for (int d = 0; d < Count; ++d) volume.at(x, y + p, first + d) = values[i++];
         }
   }
};

/// Gathers what the stages of a slice, and of those behind it, show.
template <const block_matching::Config& C, int Disparities = C.disparities, int Number = 0>
struct StageRecorder {
   using Slice = block_matching::DisparitySlice<C, Disparities, Number>;

   bool started = false;  ///< the frame, for the columns
   StageValues<C, Slice::kCount> columns, sums;
   StageRecorder<C, Slice::kRest, Number + 1> next;

   void record(const Slice& slice) {
      started = started || (slice.cost.tag.valid && slice.cost.tag.first_group);
      if (started && slice.cost.tag.valid && !slice.cost.tag.border_column) columns.append(slice.cost.column);
      if (slice.window.tag.valid && slice.window.tag.output_column) sums.append(slice.window.sum);
      next.record(slice.next);
   }
   void place(Stages& stages) const {
      columns.place(C.delay_groups(), Slice::kFirst, stages.columns);
      sums.place(0, Slice::kFirst, stages.sums);
      next.place(stages);
   }
   Stages stages() const {
      Stages stages{CostVolume(C.cost_columns(), C.height_px, C.disparities),
                    CostVolume(C.output_width_px(), C.height_px, C.disparities)};
      place(stages);
      return stages;
   }
};

template <const block_matching::Config& C, int Number>
struct StageRecorder<C, 0, Number> {
   void record(const block_matching::DisparitySlice<C, 0, Number>&) {}
   void place(Stages&) const {}
};

}  // namespace stereo::test
