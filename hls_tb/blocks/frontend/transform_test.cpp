// SPDX-License-Identifier: Apache-2.0
#include "frontend/transform.hpp"

#include <algorithm>

#include "block_matching/config.hpp"
#include "engines/clocked/heap_memories.hpp"
#include "engines/clocked/stimulus.hpp"
#include "frontend/features.hpp"
#include "scene/random.hpp"
#include "support/memory_bank.hpp"
#include "support/ports.hpp"
#include "testing/map_compare.hpp"
#include "testing/seed.hpp"
#include "testing/test_configs.hpp"
#include "testing/test_pairs.hpp"

namespace stereo::test {
namespace {

template <int W, int H, int P, int Cap, Reference Side = Reference::right>
using SobelConfig = Exactly<block_matching::Config{{.width_px = W, .height_px = H, .pixels_per_clock = P},
                                                   {DisparityCount{4}, MatchingWindow{2}, ReferenceImage{Side},
                                                    Prefiltering{.prefilter = Prefilter::xsobel, .prefilter_cap = Cap}},
                                                   {}}>;
template <int W, int H, int P, int CensusWidth, int CensusHeight, Reference Side = Reference::right,
          CensusPattern Pattern = CensusPattern::all>
using CensusConfig = Exactly<block_matching::Config{
    {.width_px = W, .height_px = H, .pixels_per_clock = P},
    {DisparityCount{4}, MatchingWindow{2}, ReferenceImage{Side}, Comparison{Cost::census},
     CensusWindow{.census_width_px = CensusWidth, .census_height_px = CensusHeight, .census_pattern = Pattern}},
    {}}>;

/// Two front clocks, which take three clocks a group.
template <int W, int H, int CensusWidth, int CensusHeight, Reference Side, CensusPattern Pattern>
using FrontConfig = Exactly<[] {
   block_matching::Config config = CensusConfig<W, H, 1, CensusWidth, CensusHeight, Side, Pattern>::kConfig;
   config.disparities = 6;
   config.clocks_per_pixel = 3;
   config.front_clocks = 2;
   return config;
}()>;

template <class Config>
class TransformTest : public ::testing::Test {};
/// Also images lower than the transform's window, and of the fewest columns and groups of rows.
using Configs =
    ::testing::Types<SobelConfig<11, 7, 1, 31>, SobelConfig<8, 2, 1, 1>, SobelConfig<12, 8, 2, 63, Reference::left>,
                     SobelConfig<9, 8, 4, 20>, SobelConfig<8, 4, 2, 31>, CensusConfig<11, 8, 1, 5, 5>,
                     CensusConfig<12, 8, 2, 7, 3, Reference::left>, CensusConfig<10, 12, 4, 3, 7>,
                     CensusConfig<9, 4, 1, 9, 7>, CensusConfig<8, 8, 4, 9, 7>,
                     CensusConfig<12, 9, 1, 9, 7, Reference::left, CensusPattern::even_columns>,
                     CensusConfig<12, 8, 2, 9, 5, Reference::right, CensusPattern::checkerboard>,
                     CensusConfig<12, 8, 4, 7, 7, Reference::right, CensusPattern::sparse>,
                     FrontConfig<48, 8, 5, 5, Reference::right, CensusPattern::all>,
                     FrontConfig<50, 7, 9, 3, Reference::left, CensusPattern::checkerboard>>;
TYPED_TEST_SUITE(TransformTest, Configs, ConfigNames);

/// Features of one image, row by row.
using Features = std::vector<uint64_t>;

/// Splits what comes out into frames, in raster order; keeps only whole ones.
template <const block_matching::Config& C>
struct TransformedFrames {
   std::vector<Features> search, reference;
   int records = 0;

   void take(const FeatureGroup<C>& shown) {
      if (!shown.valid) return;
      if (shown.start_of_frame) {
         drop_cut_frame();
         search.emplace_back(std::size_t(C.width_px * C.height_px));
         reference.emplace_back(std::size_t(C.width_px * C.height_px));
         records = 0;
      }
      if (search.empty() || records == C.width_px * C.row_groups()) return;
      for (int p = 0; p < C.pixels_per_clock; ++p) {
         const int y = records / C.width_px * C.pixels_per_clock + p;
         const std::size_t place = std::size_t(y * C.width_px + records % C.width_px);
         search.back()[place] = shown.search[p];
         reference.back()[place] = shown.reference[p];
      }
      ++records;
   }
   void drop_cut_frame() {
      if (search.empty() || records == C.width_px * C.row_groups()) return;
      search.pop_back();
      reference.pop_back();
   }
};

template <const block_matching::Config& C>
TransformedFrames<C> transformed(StimulusWriter& writer) {
   HeapMemories memories;
   Transform<C> block(memories, MemoryId<0>());
   TransformedFrames<C> frames;
   writer.bubbles(Transform<C>::kClocks);
   for (const StereoInput in : writer.clocks) {
      block.clock(in);
      frames.take(block.output());
   }
   frames.drop_cut_frame();
   return frames;
}

Features model_features(const GrayImage& image, const block_matching::Config& config) {
   if (config.cost == Cost::census)
      return census_transform(image, config.census_width_px, config.census_height_px, config.census_pattern).bits;
   const GrayImage filtered = prefiltered(image, config.prefilter_cap);
   return Features(filtered.pixels.begin(), filtered.pixels.end());
}

/// The bits of a feature one by one, each of all features, sorted: the same where only the order of the bits differs.
std::vector<std::vector<bool>> sorted_bits(const Features& features, int bits) {
   std::vector<std::vector<bool>> planes;
   for (int bit = 0; bit < bits; ++bit) {
      planes.emplace_back();
      for (const uint64_t feature : features) planes.back().push_back((feature >> bit & 1) != 0);
   }
   std::ranges::sort(planes);
   return planes;
}

/// `got` in the order search, reference.
template <const block_matching::Config& C>
void expect_features(const std::vector<ImagePair>& pairs, const TransformedFrames<C>& got) {
   ASSERT_EQ(got.search.size(), pairs.size());
   constexpr bool kRight = C.reference == Reference::right;
   Features all_expected, all_got;
   for (std::size_t i = 0; i < pairs.size(); ++i) {
      const Features of_left = model_features(pairs[i].left, C), of_right = model_features(pairs[i].right, C);
      for (const Features& features : {kRight ? of_left : of_right, kRight ? of_right : of_left})
         all_expected.insert(all_expected.end(), features.begin(), features.end());
      for (const Features& features : {got.search[i], got.reference[i]})
         all_got.insert(all_got.end(), features.begin(), features.end());
   }
   ASSERT_EQ(all_got.size(), all_expected.size());
   // The order of the bits of a census is free, as long as it is the same everywhere.
   if (C.cost == Cost::census) {
      EXPECT_EQ(sorted_bits(all_got, 64), sorted_bits(all_expected, 64));
      return;
   }
   for (std::size_t i = 0; i < all_got.size(); ++i) {
      const int place = int(i) % (C.width_px * C.height_px);
      ASSERT_EQ(all_got[i], all_expected[i]) << "x=" << place % C.width_px << " y=" << place / C.width_px
                                             << " of image " << int(i) / (C.width_px * C.height_px);
   }
}

template <const block_matching::Config& C>
std::vector<ImagePair> some_pairs(int count) {
   std::vector<ImagePair> pairs;
   for (int i = 0; i < count; ++i)
      pairs.push_back(random_pair(C.width_px, C.height_px, test_seed() + uint64_t(i), i % 3 == 2 ? 3 : 256));
   return pairs;
}

/// Records that a frame's last features wait for.
template <const block_matching::Config& C>
constexpr int kWaits = C.transform_groups() * C.width_px + C.transform_columns();

TYPED_TEST(TransformTest, FramesBackToBackAndApart) {
   static constexpr block_matching::Config C = TypeParam::kConfig;
   const std::vector<ImagePair> pairs = some_pairs<C>(7);
   for (const int stall_percent : {0, 30}) {
      SCOPED_TRACE(std::to_string(stall_percent) + " % stalls");
      StimulusWriter writer(C.pixels_per_clock, stall_percent, test_seed(), C.pixel_bits, C.clocks_per_pixel);
      for (std::size_t i = 0; i < pairs.size(); ++i) {
         writer.rows(pairs[i], {0, C.height_px});
         const int lengths[] = {0, 0, kWaits<C>, 5 * kWaits<C> + 1};
         if (i + 1 < pairs.size()) writer.random_records(lengths[i % 4]);
      }
      writer.random_records(kWaits<C>);
      expect_features<C>(pairs, transformed<C>(writer));
   }
}

TYPED_TEST(TransformTest, AStartOfFrameRestartsAtAnyPlace) {
   static constexpr block_matching::Config C = TypeParam::kConfig;
   const std::vector<ImagePair> pairs = some_pairs<C>(2);
   Random random(test_seed());
   StimulusWriter cut(C.pixels_per_clock, 0, test_seed());
   cut.rows(pairs[0], {0, C.height_px});
   for (int round = 0; round < 30; ++round) {
      StimulusWriter writer(C.pixels_per_clock, 20, test_seed() + uint64_t(round), C.pixel_bits, C.clocks_per_pixel);
      const int sent = 1 + random.below(int(cut.clocks.size()) - 1);
      for (int i = 0; i < sent; ++i) writer.record(cut.clocks[std::size_t(i)]);
      writer.rows(pairs[1], {0, C.height_px});
      writer.random_records(kWaits<C>);
      SCOPED_TRACE(std::to_string(sent) + " records before");
      expect_features<C>({pairs[1]}, transformed<C>(writer));
   }
}

}  // namespace
}  // namespace stereo::test
