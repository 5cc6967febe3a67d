// SPDX-License-Identifier: Apache-2.0
#include "phase_correlation/phase_transform.hpp"

#include <gtest/gtest.h>

#include <string>

#include "definition/mirror.hpp"
#include "definition/phase_correlation/reference_model.hpp"
#include "engines/clocked/heap_memories.hpp"
#include "engines/clocked/stimulus.hpp"
#include "scene/random.hpp"
#include "testing/seed.hpp"
#include "testing/test_pairs.hpp"

namespace stereo::test {
namespace {

using PhaseConfig = phase_correlation::Config;

constexpr PhaseConfig config(int width, int height, int scales, Reference reference, int bits = 8) {
   return {{.width_px = width, .height_px = height},
           {DisparityCount{4}, MatchingWindow{2}, PixelFormat{bits}, ReferenceImage{reference},
            phase_correlation::PhaseScales{scales}},
           {}};
}

/// Also images lower or narrower than the filters, and of the fewest columns and rows.
constexpr PhaseConfig kOne = config(11, 9, 1, Reference::right), kOneLeft = config(12, 8, 1, Reference::left),
                      kTwo = config(17, 14, 2, Reference::right), kTwoLeft = config(18, 13, 2, Reference::left),
                      kThree = config(27, 25, 3, Reference::right), kThreeLeft = config(26, 24, 3, Reference::left),
                      kNarrow = config(9, 9, 3, Reference::right), kLow = config(13, 5, 2, Reference::left),
                      kOneDeep = config(12, 8, 1, Reference::left, 12),
                      kTwoDeep = config(17, 14, 2, Reference::right, 10),
                      kThreeDeep = config(27, 25, 3, Reference::right, 12);

using Codes = std::vector<uint64_t>;

template <class Image>
Codes model_codes(const Image& image, const PhaseConfig& c) {
   if (c.reference == Reference::right) return phase_correlation::phase_codes(image, c.phase_scales).bits;
   Codes codes = phase_correlation::phase_codes(mirrored(image), c.phase_scales).bits;
   mirror_rows(codes, image.width);
   return codes;
}

/// What came out of whole frames, in raster order: left, right.
struct CodeFrames {
   int pixels;
   std::vector<Codes> left, right;

   template <class Group>
   void take(const Group& shown, bool right_is_reference) {
      if (!shown.valid) return;
      if (shown.start_of_frame) {
         drop_cut_frame();
         left.emplace_back();
         right.emplace_back();
      }
      if (left.empty() || int(left.back().size()) == pixels) return;
      left.back().push_back(right_is_reference ? shown.search[0] : shown.reference[0]);
      right.back().push_back(right_is_reference ? shown.reference[0] : shown.search[0]);
   }
   void drop_cut_frame() {
      if (left.empty() || int(left.back().size()) == pixels) return;
      left.pop_back();
      right.pop_back();
   }
};

template <const PhaseConfig& C>
using Pair = PairOf<Pixel<C>>;

template <const PhaseConfig& C>
void expect_codes(const std::vector<Pair<C>>& pairs, StimulusWriter& writer) {
   using Block = phase_correlation::PhaseTransform<phase_correlation::kCodeConfig<C>>;
   HeapMemories memories;
   Block block(memories, MemoryId<0>());
   CodeFrames frames{C.width_px * C.height_px, {}, {}};
   writer.bubbles(Block::kClocks);
   for (const CoreInput<C> in : writer.clocks) {
      block.clock(in);
      frames.take(block.output(), C.reference == Reference::right);
   }
   frames.drop_cut_frame();
   ASSERT_EQ(frames.left.size(), pairs.size());
   for (std::size_t i = 0; i < pairs.size(); ++i) {
      ASSERT_EQ(frames.left[i], model_codes(pairs[i].left, C)) << "left, frame " << i;
      ASSERT_EQ(frames.right[i], model_codes(pairs[i].right, C)) << "right, frame " << i;
   }
}

/// Records that a frame's last codes wait for.
template <const PhaseConfig& C>
constexpr int kWaits = phase_correlation::PhaseTransform<phase_correlation::kCodeConfig<C>>::kLagGroups;

template <const PhaseConfig& C>
std::vector<Pair<C>> some_pairs(int count) {
   std::vector<Pair<C>> pairs;
   const int range = 1 << C.pixel_bits;
   for (int i = 0; i < count; ++i) {
      const uint64_t seed = test_seed() + uint64_t(i);
      const int levels = i % 3 == 2 ? 3 : range;
      if constexpr (C.pixel_bits > 8)
         pairs.push_back(random_deep_pair(C.width_px, C.height_px, seed, C.pixel_bits, levels));
      else pairs.push_back(random_pair(C.width_px, C.height_px, seed, levels));
      // Extremes drive the responses to their bounds.
      if (i % 3 == 1)
         for (Pixel<C>& pixel : pairs.back().left.pixels) pixel = Pixel<C>(pixel < range / 2 ? 0 : range - 1);
   }
   return pairs;
}

template <const PhaseConfig& C>
void frames_back_to_back_and_apart() {
   const std::vector<Pair<C>> pairs = some_pairs<C>(7);
   for (const int stall_percent : {0, 30}) {
      StimulusWriter writer(1, stall_percent, test_seed(), C.pixel_bits);
      for (std::size_t i = 0; i < pairs.size(); ++i) {
         writer.rows(pairs[i], {0, C.height_px});
         const int lengths[] = {0, 0, kWaits<C>, 5 * kWaits<C> + 1};
         if (i + 1 < pairs.size()) writer.random_records(lengths[i % 4]);
      }
      writer.random_records(kWaits<C>);
      expect_codes<C>(pairs, writer);
   }
}

template <const PhaseConfig& C>
void a_start_of_frame_restarts_at_any_place() {
   const std::vector<Pair<C>> pairs = some_pairs<C>(2);
   Random random(test_seed());
   StimulusWriter cut(1, 0, test_seed(), C.pixel_bits);
   cut.rows(pairs[0], {0, C.height_px});
   for (int round = 0; round < 20; ++round) {
      StimulusWriter writer(1, 20, test_seed() + uint64_t(round), C.pixel_bits);
      const int sent = 1 + random.below(int(cut.clocks.size()) - 1);
      for (int i = 0; i < sent; ++i) writer.record(cut.clocks[std::size_t(i)]);
      writer.rows(pairs[1], {0, C.height_px});
      writer.random_records(kWaits<C>);
      SCOPED_TRACE(std::to_string(sent) + " records before");
      expect_codes<C>({pairs[1]}, writer);
   }
}

template <const PhaseConfig& C>
void expect_all() {
   SCOPED_TRACE(size_text(C.width_px, C.height_px) + ", scales " + std::to_string(C.phase_scales) + ", bits " +
                std::to_string(C.pixel_bits));
   frames_back_to_back_and_apart<C>();
   a_start_of_frame_restarts_at_any_place<C>();
}

TEST(PhaseTransform, RightReference) {
   expect_all<kOne>();
   expect_all<kTwo>();
   expect_all<kThree>();
}

TEST(PhaseTransform, LeftReference) {
   expect_all<kOneLeft>();
   expect_all<kTwoLeft>();
   expect_all<kThreeLeft>();
}

TEST(PhaseTransform, PixelsOf10And12Bits) {
   expect_all<kOneDeep>();
   expect_all<kTwoDeep>();
   expect_all<kThreeDeep>();
}

TEST(PhaseTransform, ImagesSmallerThanTheFilters) {
   expect_all<kNarrow>();
   expect_all<kLow>();
}

}  // namespace
}  // namespace stereo::test
