// SPDX-License-Identifier: Apache-2.0
// Cores with run-time settings: each frame of a stream against the reference with the settings of its start.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "engines/clocked/core_modules.hpp"
#include "engines/clocked/run_core.hpp"
#include "engines/clocked/stimulus.hpp"
#include "engines/configurations.hpp"
#include "testing/map_compare.hpp"
#include "testing/seed.hpp"
#include "testing/test_pairs.hpp"

namespace stereo::test {
namespace {

/// Those with ports for settings.
std::vector<std::size_t> settable_ones() {
   std::vector<std::size_t> places;
   for (std::size_t i = 0; i < configurations().size(); ++i)
      if (configurations()[i].shape.settings.count > 0) places.push_back(i);
   return places;
}

class SettingsTest : public ::testing::TestWithParam<std::size_t> {
  protected:
   const Configuration& configuration() const { return configurations()[GetParam()]; }
   const CoreModule& core() const { return core_module(configuration().name); }
};
INSTANTIATE_TEST_SUITE_P(Named, SettingsTest, ::testing::ValuesIn(settable_ones()),
                         [](const auto& test) { return configurations()[test.param].name; });

TEST_P(SettingsTest, EachFrameHasTheSettingsOfItsStart) {
   constexpr int kFrames = 60;
   const CoreShape& shape = core().shape;
   const Image& image = shape.image;
   const int disparities = configuration().algorithm->map_geometry(image.width_px).disparities;
   const std::vector<NamedPair> pairs = test_pairs(image.width_px, image.height_px, disparities, test_seed());
   Random random(test_seed());
   for (const int stall_percent : {0, 30}) {
      StimulusWriter writer(image.pixels_per_clock, stall_percent, test_seed());
      std::vector<const ImagePair*> sent;
      for (int frame = 0; frame < kFrames; ++frame) {
         if (frame > 0) writer.gap(shape.schedule);
         sent.push_back(&pairs[std::size_t(random.below(int(pairs.size())))].images);
         writer.rows(*sent.back(), {0, image.height_px});
      }
      writer.flush(shape.schedule);
      writer.drain(shape.schedule);
      Stimulus stimulus{configuration().name, image.pixels_per_clock, std::move(writer.clocks)};
      std::vector<std::vector<uint32_t>> chosen;
      set_frames(stimulus, shape.settings, random, [&] {
         chosen.push_back(random_settings(shape.settings, random));
         return chosen.back();
      });
      const auto maps = collect_frames(run_core(core(), stimulus), shape);
      ASSERT_EQ(maps.size(), std::size_t(kFrames));
      ASSERT_EQ(chosen.size(), std::size_t(kFrames));
      std::set<std::ptrdiff_t> invalid;
      for (std::size_t frame = 0; frame < maps.size(); ++frame) {
         std::shared_ptr<const Algorithm> algorithm = configuration().algorithm;
         std::string text;
         for (int i = 0; i < shape.settings.count; ++i) {
            const Setting& port = shape.settings.setting[i];
            if (port.largest == 0) continue;
            const std::string value = std::to_string(chosen[frame][std::size_t(i)]);
            algorithm = algorithm->with(port.name, value);
            text += std::string(" ") + port.name + "=" + value;
         }
         const ImagePair& pair = *sent[frame];
         EXPECT_TRUE(same_map(algorithm->match_reference(pair.left, pair.right), maps[frame]))
             << "frame " << frame << text;
         invalid.insert(std::ranges::count(maps[frame].valid, 0));
      }
      EXPECT_GT(invalid.size(), 5u) << "the settings change nothing";
   }
}

}  // namespace
}  // namespace stereo::test
