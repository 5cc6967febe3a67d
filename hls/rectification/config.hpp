// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rectification/warp.hpp"
#include "support/image.hpp"

namespace stereo::rectification {

/// One hardware configuration of the rectification of a pair.
struct Config : Image, Warp {
   constexpr int table_columns() const { return nodes_along(width_px); }
   constexpr int table_rows() const { return nodes_along(height_px); }
   /// A column more on either side: a tap of a shown pixel may stand there.
   constexpr int buffered_columns() const { return (width_px + 2 + 1) / 2 * 2; }

   template <class Self, class Visitor>
   static constexpr void options(Self& self, Visitor& visit) {
      Image::options(self, visit);
      Warp::options(self, visit);
   }

   /// Why this core cannot be built; empty when it can. Each block relies on it instead of repeating it.
   constexpr Sentence problem() const {
      if (const Sentence sentence = Image::problem(); !sentence.empty()) return sentence;
      if (const Sentence sentence = Warp::problem(); !sentence.empty()) return sentence;
      if (pixels_per_clock != 1) return "rectification takes one pixel pair a clock";
      if (lag_rows() >= height_px) {
         Sentence sentence = "the image height is ";
         return sentence << height_px << " but must be above the number of rows below plus 1, which is " << lag_rows();
      }
      if (buffered_columns() / 2 * (buffered_rows() / 2) > kMostWords)
         return "the buffered rows have more words than an address of 16 bits reaches";
      return {};
   }

  private:
   static constexpr int kMostWords = 1 << 16;
};

}  // namespace stereo::rectification
