// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <type_traits>

#include "dynamic_range/config.hpp"
#include "postprocessing/map_column.hpp"
#include "winner/map_group.hpp"

namespace stereo::dynamic_range {

/// The map of the winners of a search window, each on top of where its window begins. 1 clock. `Clocks`: from the
/// choice of a window to its winner here.
template <const Config& C, const auto& W, int Clocks>
struct ShownMap {
   static constexpr int kClocks = 1;
   /// For the ports, or for the stages behind it.
   using Map = std::conditional_t<C.has_map_block(), MapColumn<kMapConfig<C>>, MapGroup<W>>;

   uint16_t base[Clocks + 1];  ///< [j]: of the choice j clocks ago; [0] is not used
   Map map;

   HLS_INLINE ShownMap() { fill(base, uint16_t(0)); }

   /// Without a group of their own.
   template <class Visitor>
   HLS_INLINE void groups(Visitor& visit) {
      visit("base", base);
      visit("map", map);
   }

   /// refined: the winner's refinement, of the choices before.
   template <class Refined, class Choice>
   HLS_INLINE void clock(const Refined& refined, const Choice& choice) {
      if constexpr (C.has_map_block()) map = map_column<kMapConfig<C>>(refined.output(choice, NoTexture()));
      else map = map_group<W>(refined.output(choice, NoTexture()));
      map.disparity[0] = uint16_t(map.disparity[0] + C.steps_per_pixel() * base_of_winner(choice));
      HLS_UNROLL
      for (int j = Clocks; j > 0; --j) base[j] = j == 1 ? choice.base : base[j - 1];
   }

  private:
   struct NoTexture {};

   template <class Choice>
   HLS_INLINE uint16_t base_of_winner(const Choice& choice) const {
      if constexpr (Clocks == 0) return choice.base;
      else return base[Clocks];
   }
};

}  // namespace stereo::dynamic_range
