// SPDX-License-Identifier: Apache-2.0
// Cores with run-time settings: each frame of a stream against the reference with the settings of its start.
#include <gtest/gtest.h>

#include <set>

#include "engines/clocked/core_modules.hpp"
#include "engines/clocked/run_core.hpp"
#include "engines/clocked/stimulus.hpp"
#include "engines/configurations.hpp"
#include "testing/map_compare.hpp"
#include "testing/seed.hpp"
#include "testing/test_pairs.hpp"
#include "testing/tested_cores.hpp"

namespace stereo::test {
namespace {

/// Those with ports for settings.
std::vector<std::size_t> settable_ones() {
   std::vector<std::size_t> places = tested_configurations();
   std::erase_if(places, [](std::size_t place) { return configurations()[place].shape.settings.count == 0; });
   return places;
}

class SettingsTest : public ::testing::TestWithParam<std::size_t> {
  protected:
   const Configuration& configuration() const { return configurations()[GetParam()]; }
   const CoreModule& core() const { return core_module(configuration().name); }
};
INSTANTIATE_TEST_SUITE_P(Named, SettingsTest, ::testing::ValuesIn(settable_ones()),
                         [](const auto& test) { return configurations()[test.param].name; });

/// That a frame brings, and not a reset.
bool is_set_by_frame(const Setting& port) { return port.largest > 0 && !port.held; }

/// The algorithm with the settings of a frame, but for one of them (-1: with all).
std::shared_ptr<const Algorithm> set(std::shared_ptr<const Algorithm> algorithm, const SettingList& ports,
                                     const std::vector<uint32_t>& values, int left_out) {
   for (int i = 0; i < ports.count; ++i)
      if (is_set_by_frame(ports.setting[i]) && i != left_out)
         algorithm = algorithm->with(ports.setting[i].name, std::to_string(values[std::size_t(i)]));
   return algorithm;
}

TEST_P(SettingsTest, EachFrameHasTheSettingsOfItsStart) {
   constexpr int kFrames = 120;
   const CoreShape& shape = core().shape;
   const Image& image = shape.image;
   const int disparities = configuration().algorithm->map_geometry(image.width_px).disparities;
   const std::vector<NamedPair> pairs = test_pairs(image.width_px, image.height_px, disparities, test_seed());
   Random random(test_seed());
   for (const int stall_percent : {0, 30}) {
      StimulusWriter writer(shape, stall_percent, test_seed());
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
      std::set<int> idle;  // ports without an effect so far
      for (int i = 0; i < shape.settings.count; ++i)
         if (is_set_by_frame(shape.settings.setting[i])) idle.insert(i);
      for (std::size_t frame = 0; frame < maps.size(); ++frame) {
         const ImagePair& pair = *sent[frame];
         const auto expected = [&](int left_out) {
            return set(configuration().algorithm, shape.settings, chosen[frame], left_out)
                ->match_reference(pair.left, pair.right);
         };
         EXPECT_TRUE(same_map(expected(-1), maps[frame]))
             << "frame " << frame << ::testing::PrintToString(chosen[frame]);
         std::erase_if(idle, [&](int port) { return !same_map(expected(port), maps[frame]); });
      }
      for (const int port : idle) ADD_FAILURE() << shape.settings.setting[port].name << " changes no frame";
   }
}

/// Those with ports for the size of the images.
std::vector<std::size_t> sized_ones() {
   std::vector<std::size_t> places;
   for (const std::size_t i : settable_ones())
      if (has_size_ports(configurations()[i].shape.settings)) places.push_back(i);
   return places;
}

class SizeTest : public SettingsTest {};
INSTANTIATE_TEST_SUITE_P(Named, SizeTest, ::testing::ValuesIn(sized_ones()),
                         [](const auto& test) { return configurations()[test.param].name; });

TEST_P(SizeTest, EachResetBringsItsSize) {
   constexpr int kSizes = 40, kFrames = 3;
   Random random(test_seed());
   HeapMemories memories;
   std::set<std::pair<int, int>> seen;
   for (int i = 0; i < kSizes; ++i) {
      const Image size = random_size(core().shape, random);
      seen.insert({size.width_px, size.height_px});
      const CoreShape shape = shape_at(core().shape, size);
      const int disparities = configuration().algorithm->map_geometry(size.width_px).disparities;
      const auto pairs = test_pairs(size.width_px, size.height_px, disparities, random.bits());
      StimulusWriter writer(shape, i % 2 == 0 ? 0 : 30, random.bits());
      writer.reset_to_size(1, size.width_px, size.height_px);
      std::vector<const ImagePair*> sent;
      for (int frame = 0; frame < kFrames; ++frame) {
         if (frame > 0) writer.gap(shape.schedule);
         sent.push_back(&pairs[std::size_t(random.below(int(pairs.size())))].images);
         writer.rows(*sent.back(), {0, size.height_px});
      }
      writer.flush(shape.schedule);
      writer.drain(shape.schedule);
      Stimulus stimulus{configuration().name, size.pixels_per_clock, std::move(writer.clocks),
                        std::move(writer.resets)};
      std::vector<std::vector<uint32_t>> chosen;
      const auto next = [&] {
         chosen.push_back(random_settings(shape.settings, random));
         return chosen.back();
      };
      set_frames(stimulus, shape.settings, random, next, writer.sizes);
      const auto maps = collect_frames(run_core(core(), stimulus, memories), shape);
      ASSERT_EQ(maps.size(), std::size_t(kFrames));
      // The reset's clock carries garbage, too, which may look like a start of frame.
      const std::size_t before = chosen.size() - maps.size();
      for (std::size_t frame = 0; frame < maps.size(); ++frame) {
         const auto algorithm = set(configuration().algorithm, shape.settings, chosen[before + frame], -1);
         EXPECT_TRUE(same_map(algorithm->match_reference(sent[frame]->left, sent[frame]->right), maps[frame]))
             << size.width_px << "x" << size.height_px << " frame " << frame;
      }
   }
   EXPECT_GT(seen.size(), std::size_t(kSizes) / 2);
}

}  // namespace
}  // namespace stereo::test
