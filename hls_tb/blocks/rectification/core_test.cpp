// SPDX-License-Identifier: Apache-2.0
// The core against the definition, in every clock.
#include "rectification/core.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <deque>
#include <set>
#include <string>
#include <vector>

#include "block_matching/core.hpp"
#include "definition/block_matching/reference_model.hpp"
#include "definition/rectification/reference_model.hpp"
#include "engines/clocked/heap_memories.hpp"
#include "engines/clocked/register_list.hpp"
#include "scene/random.hpp"
#include "testing/seed.hpp"
#include "testing/types.hpp"

namespace stereo::test {
namespace {

using rectification::Config;
using rectification::Offset;
using rectification::Table;
using rectification::TableWrite;

constexpr Config kPlain{{.width_px = 40, .height_px = 24}, {.grid_px = 8, .rows_above = 3, .rows_below = 4}};
constexpr Config kOdd{
    {.width_px = 33, .height_px = 17},
    {.grid_px = 4, .offset_bits = 9, .offset_fraction_bits = 4, .weight_bits = 3, .rows_above = 0, .rows_below = 0}};
constexpr Config kOneCell{
    {.width_px = 21, .height_px = 40},
    {.grid_px = 64, .offset_bits = 15, .offset_fraction_bits = 8, .weight_bits = 8, .rows_above = 10, .rows_below = 7}};
constexpr Config k10Bits{{.width_px = 24, .height_px = 19},
                         {.pixel_bits = 10, .grid_px = 8, .weight_bits = 8, .rows_above = 2, .rows_below = 3}};
constexpr Config k12Bits{{.width_px = 33, .height_px = 21},
                         {.pixel_bits = 12, .grid_px = 8, .offset_bits = 12, .rows_above = 4, .rows_below = 2}};
constexpr Config kLateRows{{.width_px = 8, .height_px = 11},
                           {.grid_px = 16, .weight_bits = 1, .rows_above = 1, .rows_below = 9}};

template <const Config& C>
struct Named {
   static constexpr const Config& kConfig = C;
};
template <class Name>
class RectificationCore : public ::testing::Test {};
using Configs = FewOrAll<::testing::Types<Named<kOdd>, Named<k12Bits>>,
                         ::testing::Types<Named<kPlain>, Named<kOneCell>, Named<kLateRows>, Named<k10Bits>>>;
TYPED_TEST_SUITE(RectificationCore, Configs);

/// The pair that leaves for one that came in.
struct Leaving {
   bool known = true;
   bool starts = false;
   int left = 0, right = 0;
};

struct TablePair {
   Table left, right;
};

/// Still pictures, small moves and offsets that lead anywhere.
Table random_table(const Config& config, Random& random) {
   Table table(config, config.width_px, config.height_px);
   const int most = config.largest_offset(), small = 4 << config.offset_fraction_bits;
   const int reach = random.percent(50) ? most : std::min(most, small);
   const bool still = random.percent(10);
   for (Offset& node : table.nodes)
      if (!still) node = {random.below(2 * reach + 2) - reach - 1, random.below(2 * reach + 2) - reach - 1};
   return table;
}

template <const Config& C>
TablePair random_tables(Random& random) {
   return {random_table(C, random), random_table(C, random)};
}

/// Grey values over the whole range, the largest one often.
template <const Config& C>
Pixel<C> random_pixel(Random& random) {
   constexpr int kLargest = (1 << C.pixel_bits) - 1;
   return Pixel<C>(random.percent(10) ? kLargest : random.below(kLargest + 1));
}

template <const Config& C>
PairOf<Pixel<C>> random_pair(Random& random) {
   PairOf<Pixel<C>> pair{{C.width_px, C.height_px}, {C.width_px, C.height_px}};
   for (auto* image : {&pair.left, &pair.right})
      for (Pixel<C>& pixel : image->pixels) pixel = random_pixel<C>(random);
   return pair;
}

/// Both images by definition.
template <const Config& C>
PairOf<Pixel<C>> rectified_pair(const PairOf<Pixel<C>>& pair, const TablePair& tables) {
   return {rectification::rectified(pair.left, tables.left, C), rectification::rectified(pair.right, tables.right, C)};
}

/// The clocks that load both tables: `use` gets the nodes.
template <class Use>
void for_each_node(const TablePair& tables, Use use) {
   for (const bool right : {false, true}) {
      const Table& table = right ? tables.right : tables.left;
      for (int j = 0; j < table.rows; ++j)
         for (int i = 0; i < table.columns; ++i) {
            const Offset& node = table.at(i, j);
            use(TableWrite{true, right, uint16_t(i), uint16_t(j), int16_t(node.x), int16_t(node.y)});
         }
   }
}

/// A core, and what is expected of it.
template <const Config& C>
class Bench {
  public:
   using Core = rectification::Core<C>;
   static constexpr int kPixels = C.width_px * C.height_px;

   Bench(Random& random, HeapMemories& memories) : random_(random), core_(memories), valid_(Core::kLatency, false) {}

   void load(const TablePair& tables) {
      tables_ = tables;
      for_each_node(tables, [this](const TableWrite& write) {
         clock({}, write);
         if (random_.percent(20)) clock({}, {});
      });
   }

   /// A frame, or its first pixels, with bubbles between them.
   void frame(const PairOf<Pixel<C>>& pair, int bubbles_percent, int pixels = kPixels) {
      const PairOf<Pixel<C>> leaves = rectified_pair<C>(pair, tables_);
      const std::size_t first = pairs_in_ + std::size_t(C.lag_rows() * C.width_px);
      // A frame that is broken off may show rows of its own until the next one leaves.
      const std::size_t from = pixels == kPixels ? first : pairs_in_;
      expected_.resize(first + kPixels);
      for (std::size_t n = from; n < first + kPixels; ++n) {
         const std::size_t i = n - first;
         expected_[n] = pixels == kPixels ? Leaving{true, i == 0, leaves.left.pixels[i], leaves.right.pixels[i]}
                                          : Leaving{.known = false};
      }
      for (int n = 0; n < pixels; ++n) {
         bubbles(bubbles_percent);
         clock({.left = {pair.left.pixels[std::size_t(n)]},
                .right = {pair.right.pixels[std::size_t(n)]},
                .start_of_frame = n == 0,
                .valid = true},
               {});
      }
   }

   /// Pairs without start of frame, and bubbles.
   void between(int pairs, int bubbles_percent) {
      for (int n = 0; n < pairs; ++n) {
         bubbles(bubbles_percent);
         clock({.left = {random_pixel<C>(random_)}, .right = {random_pixel<C>(random_)}, .valid = true}, {});
      }
   }

   /// What has gone in comes out.
   void drain() {
      for (int clocks = 0; clocks < Core::kLatency; ++clocks) clock({}, {});
      EXPECT_EQ(pairs_out_, pairs_in_);
   }

   int frames_out() const { return frames_out_; }

  private:
   void bubbles(int percent) {
      while (random_.percent(percent))
         clock({.left = {random_pixel<C>(random_)},
                .right = {random_pixel<C>(random_)},
                .start_of_frame = random_.percent(50)},
               {});
   }

   void clock(const CoreInput<C>& in, const TableWrite& table) {
      check(core_.output());
      core_.clock(in, table);
      valid_.pop_front();
      valid_.push_back(in.valid);
      pairs_in_ += in.valid ? 1 : 0;
   }

   void check(const CoreInput<C>& out) {
      ASSERT_EQ(out.valid, valid_.front()) << "after pair " << pairs_out_;
      if (!out.valid) {
         ASSERT_FALSE(out.start_of_frame) << "after pair " << pairs_out_;
         return;
      }
      const Leaving wanted = pairs_out_ < expected_.size() ? expected_[pairs_out_] : Leaving();
      if (wanted.known) {
         ASSERT_EQ(out.start_of_frame, wanted.starts) << "pair " << pairs_out_;
         ASSERT_EQ(out.left[0], wanted.left) << "pair " << pairs_out_;
         ASSERT_EQ(out.right[0], wanted.right) << "pair " << pairs_out_;
         frames_out_ += wanted.starts ? 1 : 0;
      }
      ++pairs_out_;
   }

   Random& random_;
   Core core_;
   TablePair tables_;
   std::deque<bool> valid_;         ///< of the last kLatency clocks, oldest first
   std::vector<Leaving> expected_;  ///< for each pair that comes in; behind the last one zeros
   std::size_t pairs_in_ = 0, pairs_out_ = 0;
   int frames_out_ = 0;
};

TYPED_TEST(RectificationCore, MakesThePixelsOfTheDefinitionInTheirClocks) {
   static constexpr Config C = TypeParam::kConfig;
   constexpr int kFlush = rectification::Core<C>::kSchedule.flush_groups;
   static_assert(kFlush == C.lag_rows() * C.width_px);
   static_assert(rectification::Core<C>::kLatency == 24, "docs/rectification.md says so");
   Random random(test_seed());
   for (int round = 0; round < 12; ++round) {
      HeapMemories memories;
      Bench<C> bench(random, memories);
      const int bubbles = round % 3 * 25;
      bench.between(random.below(3 * C.width_px), bubbles);
      bench.load(random_tables<C>(random));
      for (int frame = 0; frame < 3; ++frame) bench.frame(random_pair<C>(random), bubbles);  // back to back
      bench.between(kFlush + random.below(2 * C.width_px), bubbles);
      bench.frame(random_pair<C>(random), bubbles, 1 + random.below(C.width_px * C.height_px - 1));  // broken off
      bench.frame(random_pair<C>(random), bubbles);
      bench.between(kFlush, bubbles);
      bench.drain();
      bench.load(random_tables<C>(random));
      bench.frame(random_pair<C>(random), bubbles);
      bench.between(kFlush, bubbles);
      bench.drain();
      if (this->HasFatalFailure()) return;
      EXPECT_EQ(bench.frames_out(), 5);
   }
}

TYPED_TEST(RectificationCore, NeedsNothingButItsTablesAfterAReset) {
   static constexpr Config C = TypeParam::kConfig;
   Random random(test_seed());
   HeapMemories memories;
   Bench<C> before(random, memories);
   before.load(random_tables<C>(random));
   before.frame(random_pair<C>(random), 0);
   Bench<C> after(random, memories);  // a core on the memories of another one starts as after a reset
   after.load(random_tables<C>(random));
   after.frame(random_pair<C>(random), 10);
   after.between(C.lag_rows() * C.width_px, 10);
   after.drain();
   EXPECT_EQ(after.frames_out(), 1);
}

TYPED_TEST(RectificationCore, NamesEachRegisterOnce) {
   HeapMemories memories;
   rectification::Core<TypeParam::kConfig> core(memories);
   std::vector<RegisterView> registers;
   RegisterLister lister(registers);
   core.registers(lister);
   std::set<std::string> names;
   std::set<const void*> places;
   for (const RegisterView& shown : registers) {
      EXPECT_TRUE(names.insert(shown.name).second) << shown.name;
      EXPECT_TRUE(places.insert(shown.address).second) << shown.name;
   }
   EXPECT_GT(names.size(), 100U);
}

constexpr Config kBefore{{.width_px = 32, .height_px = 20}, {.grid_px = 8, .rows_above = 5, .rows_below = 5}};
constexpr block_matching::Config kMatching{
    {.width_px = 32, .height_px = 20}, {DisparityCount{8}, MatchingWindow{3}}, {SliceSize{4}}};

/// What leaves goes into a matching core as it is: the second of two frames needs the rows of nothing but the flush.
TEST(RectificationBeforeMatching, IsTheMapOfTheRectifiedPair) {
   using Matcher = block_matching::Core<kMatching>;
   using Rectifier = rectification::Core<kBefore>;
   Random random(test_seed());
   HeapMemories memories, matcher_memories;
   Rectifier rectifier(memories);
   Matcher matcher(matcher_memories);
   std::vector<int> disparities, expected;
   const auto clock = [&](const StereoInput& in, const TableWrite& table) {
      if (const StereoOutput out = matcher.output(); out.valid) disparities.push_back(out.disparity[0]);
      matcher.clock(rectifier.output());
      rectifier.clock(in, table);
   };
   const TablePair tables = random_tables<kBefore>(random);
   for_each_node(tables, [&](const TableWrite& write) { clock({}, write); });
   for (int frame = 0; frame < 2; ++frame) {
      const ImagePair pair = random_pair<kBefore>(random), rectified = rectified_pair<kBefore>(pair, tables);
      const DisparityMap map = block_matching::match_reference(rectified.left, rectified.right, kMatching);
      expected.insert(expected.end(), map.disparity.begin(), map.disparity.end());
      for (std::size_t n = 0; n < pair.left.pixels.size(); ++n)
         clock(
             {.left = {pair.left.pixels[n]}, .right = {pair.right.pixels[n]}, .start_of_frame = n == 0, .valid = true},
             {});
   }
   const int flush = Rectifier::kSchedule.flush_groups + Matcher::kSchedule.flush_groups;
   for (int n = 0; n < flush; ++n) clock({.left = {random.byte()}, .right = {random.byte()}, .valid = true}, {});
   for (int n = 0; n < Rectifier::kLatency + Matcher::kSchedule.latency_clocks; ++n) clock({}, {});
   EXPECT_EQ(disparities, expected);
}

}  // namespace
}  // namespace stereo::test
