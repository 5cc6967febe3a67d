// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "scene/random.hpp"
#include "semi_global/column_line.hpp"

namespace stereo::test {

/// Columns of a folded semi-global core on their way, at random times: the line that the blocks see, and which column
/// and phase is at which stage.
template <const semi_global::Config& C>
class PhaseStream {
  public:
   static constexpr int kPhases = C.clocks_per_pixel;

   struct Place {
      int column = -1;  ///< -1: none
      int phase = 0;
   };

   PhaseStream(Random& random, int bubbles_percent) : random_(random), bubbles_percent_(bubbles_percent) {}

   semi_global::ColumnLine<C, -8> line;

   int sent() const { return int(starts_.size()); }

   Place at(int stage) const {
      for (int i = sent() - 1; i >= 0; --i) {
         const int phase = clock_ - starts_[std::size_t(i)] - stage;
         if (phase >= kPhases) break;
         if (phase >= 0) return {i, phase};
      }
      return {};
   }

   /// The column of the windows that are there: the tags that the line shows are those of their centres.
   Place centre_at(int stage) const {
      Place place = at(stage);
      if (place.column >= 0) place.column -= semi_global::kWindowConfig<C>.columns_after();
      return place;
   }

   /// The clock edge. tag: of the next column, which comes now or later; not valid: none comes any more.
   void clock(const PixelTag& tag) {
      PixelTag now = tag;
      now.valid = tag.valid && rest_ == 0 && !random_.percent(bubbles_percent_);
      if (now.valid) starts_.push_back(clock_ + 9);
      rest_ = now.valid ? kPhases - 1 : rest_ > 0 ? rest_ - 1 : 0;
      line.clock(now, FixedSize<semi_global::kWindowConfig<C>>());
      ++clock_;
   }

  private:
   Random& random_;
   int bubbles_percent_;
   int clock_ = 0, rest_ = 0;
   std::vector<int> starts_;  ///< the clock of each column's stage 0
};

}  // namespace stereo::test
