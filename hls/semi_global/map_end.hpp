// SPDX-License-Identifier: Apache-2.0
// From the winners to the map: the same in a core with several clocks a pixel pair.
#pragma once

#include <type_traits>

#include "postprocessing/post_processor.hpp"
#include "semi_global/config.hpp"
#include "support/hls_support.hpp"
#include "support/optional_block.hpp"
#include "winner/map_group.hpp"
#include "winner/median.hpp"
#include "winner/winners.hpp"

namespace stereo::semi_global {

/// What makes the map of the winners. Whole disparities without a median are ready as they are.
template <const Config& C>
inline constexpr bool kHasMapBlock = C.median || C.subpixel || C.has_post_processing();
template <const Config& C>
using MapBlock = std::conditional_t<
    C.has_post_processing(), PostProcessor<C>,
    std::conditional_t<C.median, Median<kSumConfig<C>>, Optional<C.subpixel, MapRegister<kSumConfig<C>>>>>;

/// The refinement asks for no texture.
struct NoTexture {};

template <const Config& C, class Core>
HLS_INLINE Winners<kSumConfig<C>> checked(const Core& core) {
   if constexpr (C.has_left_right_check()) return core.leftright.checked;
   else return core.refinement.output(core.winners, NoTexture());
}

/// In raster order.
template <const Config& C, class Core>
HLS_INLINE Winners<kSumConfig<C>> turned(const Core& core) {
   if constexpr (C.path_right) return core.turn.output();
   else return checked<C>(core);
}

template <const Config& C, class Core>
HLS_INLINE auto shown_group(const Core& core) {
   if constexpr (C.has_post_processing()) return core.map.group();
   else if constexpr (kHasMapBlock<C>) return core.map.out;
   else return map_group<kSumConfig<C>>(turned<C>(core));
}

/// The clock edge of what stands behind the check.
template <const Config& C, class Core, class Size>
HLS_INLINE void clock_map(Core& core, const Size& size) {
   if constexpr (C.has_post_processing()) core.map.clock(turned<C>(core), size, core.settings);
   else if constexpr (C.median) core.map.clock(turned<C>(core), size);
   else if constexpr (kHasMapBlock<C>) core.map.clock(turned<C>(core));
   if constexpr (C.path_right) core.turn.clock(checked<C>(core), size);
}

}  // namespace stereo::semi_global
