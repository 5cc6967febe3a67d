// SPDX-License-Identifier: Apache-2.0
#include "fuzz/map_promises.hpp"
#include "fuzz/memory_file.hpp"
#include "program/errors.hpp"
#include "program/evaluation/masks.hpp"
#include "program/evaluation/measures.hpp"
#include "program/io/disparity_files.hpp"

namespace stereo::fuzz {
namespace {

constexpr std::size_t kMostPixels = 4096;  ///< that are evaluated: more only take time

void evaluate(const app::DisparityImage& map) {
   for (const Reference side : {Reference::left, Reference::right})
      for (const int border : {0, 2})
         for (const app::NamedMask& mask :
              app::evaluation_masks(GrayImage(map.width, map.height), map, &map, side, border)) {
            const app::Measures measures = app::measure(map, map, mask.mask);
            promise(measures.valid == measures.pixels && measures.d1 == 0, "a map does not differ from itself");
         }
}

}  // namespace

bool disparities(std::string_view bytes) {
   const MemoryFile file(bytes);
   bool taken = false;
   for (const double scale : {1.0, 4.0, 1e-6, 1e-300}) try {
         const app::DisparityImage map = app::load_disparities("--truth-left", file.path(), {.scale = scale}).image;
         taken = true;
         check_map(map);
         if (map.px.size() <= kMostPixels) evaluate(map);
      } catch (const app::InputError& refusal) {
         check_refusal(refusal, "--truth-left " + file.path() + ": ");
      }
   return taken;
}

}  // namespace stereo::fuzz
