// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dynamic_range/window_bases.hpp"

namespace stereo::dynamic_range {

/// Where the search windows stand at the centre of the matching window that the newest column completes, `Clocks` after
/// the column comes.
template <const Config& C, int Clocks>
struct CentreBase {
   static constexpr int kAfter = (C.window_px - 1) / 2;

   uint16_t held[kTracks][kAfter];  ///< [j]: of the column j+1 before the newest
   uint16_t line[kTracks][Clocks];  ///< [j]: of j+1 clocks ago

   HLS_INLINE CentreBase() { start(*this); }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("held", held);
      visit("line", line);
   }

   HLS_INLINE uint16_t base(int track) const { return line[track][Clocks - 1]; }

   HLS_INLINE void clock(const WindowBases<C>& bases) {
      HLS_UNROLL
      for (int track = 0; track < kTracks; ++track) {
         HLS_UNROLL
         for (int j = Clocks - 1; j > 0; --j) line[track][j] = line[track][j - 1];
         line[track][0] = held[track][kAfter - 1];
         HLS_UNROLL
         for (int j = kAfter - 1; j > 0; --j)
            held[track][j] = select<uint16_t>(bases.stands.valid, held[track][j - 1], held[track][j]);
         held[track][0] = select<uint16_t>(bases.stands.valid, bases.base[track][kCentre], held[track][0]);
      }
   }
};

}  // namespace stereo::dynamic_range
