// SPDX-License-Identifier: Apache-2.0
#include "scene/stress_pairs.hpp"

#include <algorithm>
#include <numeric>
#include <vector>

#include "scene/scene.hpp"

namespace stereo {
namespace {

/// Draws into a pair of one shape.
class Painter {
  public:
   Painter(const StressShape& shape, Random& random)
       : pair{DeepImage(shape.width, shape.height), DeepImage(shape.width, shape.height)},
         shape_(shape),
         random_(random),
         top_((1 << shape.pixel_bits) - 1) {}

   void scene();
   void noise(int levels, int step);
   void few_levels();
   void blocks();
   enum class Jumps { anywhere, between_ends, to_neighbours };
   void steps(Jumps jumps);
   void periodic();
   void constant();
   void opposed();
   int slopes();
   void rough();
   void tiles();
   void contrary();
   void bands();
   void enlarged();
   void ramp();
   void patchwork();

   DeepPair pair;

  private:
   int last_disparity() const { return shape_.first_disparity + shape_.disparities - 1; }
   int any_disparity() { return shape_.first_disparity + random_.below(shape_.disparities); }
   uint16_t either_end() { return uint16_t(random_.percent(50) ? 0 : top_); }

   template <class Value>
   void fill(DeepImage& image, Value value) {
      for (int y = 0; y < shape_.height; ++y)
         for (int x = 0; x < shape_.width; ++x) image.at(x, y) = value(x, y);
   }
   /// left(x + disparity, y) = value of right(x, y) for x in first ... end-1.
   template <class Value>
   void match(int y, int first, int end, int disparity, Value value) {
      for (int x = std::max(first, -disparity); x < std::min(end, shape_.width - disparity); ++x)
         pair.left.at(x + disparity, y) = value(pair.right.at(x, y));
   }
   void match_all(int disparity) {
      for (int y = 0; y < shape_.height; ++y) match(y, 0, shape_.width, disparity, [](uint16_t v) { return v; });
   }
   /// Rectangles of black and white, of any size up to a third of the image.
   void draw_blocks(DeepImage& image) {
      const int wide = 1 + random_.below(std::min(12, shape_.width)),
                high = 1 + random_.below(std::min(9, shape_.height));
      std::vector<uint16_t> levels;
      const int columns = shape_.width / wide + 1, rows = shape_.height / high + 1;
      for (int i = 0; i < columns * rows; ++i) levels.push_back(either_end());
      fill(image, [&](int x, int y) { return levels[std::size_t(y / high * columns + x / wide)]; });
   }

   const StressShape& shape_;
   Random& random_;
   const int top_;  ///< the largest grey value
};

void Painter::scene() {
   // Wide enough for a scene of the whole range; the part at random.
   const int disparities = std::clamp(last_disparity() + 1, 2, 256);
   const int width = std::max(shape_.width, disparities + 1);
   Scene made =
       make_scene({.width = width, .height = shape_.height, .disparities = disparities, .seed = random_.bits()});
   const DeepPair deep = shape_.pixel_bits > 8 ? deepened(made.images, shape_.pixel_bits, random_.bits())
                                               : DeepPair{widened(made.images.left), widened(made.images.right)};
   const int from = random_.below(width - shape_.width + 1);
   fill(pair.left, [&](int x, int y) { return deep.left.at(from + x, y); });
   fill(pair.right, [&](int x, int y) { return deep.right.at(from + x, y); });
}

void Painter::noise(int levels, int step) {
   const int base = random_.below(top_ - (levels - 1) * step + 1);
   for (DeepImage* image : {&pair.left, &pair.right})
      fill(*image, [&](int, int) { return uint16_t(base + random_.below(levels) * step); });
}

void Painter::few_levels() {
   const int levels = 2 + random_.below(4);
   noise(levels, random_.percent(50) ? top_ / (levels - 1) : 1);
   if (random_.percent(50)) return;
   for (int y = 0; y < shape_.height; ++y) match(y, 0, shape_.width, any_disparity(), [](uint16_t v) { return v; });
}

void Painter::blocks() {
   draw_blocks(pair.right);
   draw_blocks(pair.left);
   // A third of them unrelated.
   const int disparity = any_disparity(), way = random_.below(3);
   for (int y = 0; y < shape_.height && way > 0; ++y)
      match(y, 0, shape_.width, disparity, [&](uint16_t v) { return uint16_t(way == 1 ? v : top_ - v); });
}

void Painter::steps(Jumps jumps) {
   // Few levels make places that match at several disparities.
   const int levels = random_.percent(40) ? 2 + random_.below(14) : top_ + 1;
   noise(levels, random_.percent(50) ? top_ / (levels - 1) : 1);
   const int longest = std::max(2, shape_.width / 2), beyond = last_disparity() + 1;
   int now = random_.percent(70) ? last_disparity() : shape_.first_disparity;
   const auto disparity = [&] {
      const int ends[] = {shape_.first_disparity, last_disparity(), shape_.first_disparity + 1, last_disparity() - 1,
                          beyond};
      if (jumps == Jumps::between_ends) return ends[random_.below(random_.percent(20) ? 5 : 2)];
      if (jumps == Jumps::anywhere) return any_disparity();
      // Back to an end now and then, else it would be left for long.
      if (random_.percent(20)) now = random_.percent(70) ? last_disparity() : shape_.first_disparity;
      now = std::clamp(now + (random_.percent(30) ? random_.below(7) - 3 : random_.below(3) - 1),
                       shape_.first_disparity, last_disparity());
      return now;
   };
   for (int y = 0; y < shape_.height;) {
      const int rows = 1 + random_.below(5);
      for (int x = 0; x < shape_.width;) {
         const bool is_short = jumps == Jumps::to_neighbours || random_.percent(50);
         const int end = x + 1 + random_.below(is_short ? 8 : longest), here = disparity();
         for (int row = y; row < std::min(y + rows, shape_.height); ++row)
            match(row, x, std::min(end, shape_.width), here, [](uint16_t v) { return v; });
         x = end;
      }
      y += rows;
   }
}

void Painter::periodic() {
   const int period = 2 + random_.below(std::max(1, shape_.disparities - 1)), high = 1 + random_.below(4);
   std::vector<uint16_t> pattern(std::size_t(period * high));
   const bool two = random_.percent(50);
   for (uint16_t& level : pattern) level = two ? either_end() : uint16_t(random_.below(top_ + 1));
   const int shift = random_.below(period);
   fill(pair.right, [&](int x, int y) { return pattern[std::size_t(y % high * period + x % period)]; });
   fill(pair.left, [&](int x, int y) { return pattern[std::size_t(y % high * period + (x + shift) % period)]; });
}

void Painter::constant() {
   const uint16_t level = random_.percent(60) ? either_end() : uint16_t(random_.below(top_ + 1));
   const int others = random_.percent(40) ? 0 : random_.below(4);  // in a hundred
   for (DeepImage* image : {&pair.left, &pair.right})
      fill(*image, [&](int, int) { return random_.percent(others) ? uint16_t(random_.below(top_ + 1)) : level; });
}

void Painter::opposed() {
   const bool right_is_dark = random_.percent(50);
   const int border = random_.percent(50) ? 0 : random_.below(shape_.width);  // the other way round before it
   // With noise the largest costs differ, so that each of them may win.
   const int noise = random_.percent(50) ? 1 : 2 + random_.below(top_ / 8);
   const auto level = [&](bool dark) { return uint16_t(dark ? random_.below(noise) : top_ - random_.below(noise)); };
   fill(pair.right, [&](int x, int) { return level((x < border) != right_is_dark); });
   fill(pair.left, [&](int x, int) { return level((x < border) == right_is_dark); });
   if (random_.percent(30)) {
      const int x = random_.below(shape_.width), y = random_.below(shape_.height);
      pair.right.at(x, y) ^= uint16_t(top_);
   }
}

/// Returns how steep they are, in grey levels from a column to the next.
int Painter::slopes() {
   // As steep as the grey levels allow without a jump back to the first one, in images that are not too wide.
   const auto step = [&](int levels, int length) { return random_.below(std::clamp(levels / length, 1, 8)) + 1; };
   const int across = step(top_ + 1, shape_.width), left_over = top_ + 1 - across * shape_.width;
   const int down = random_.percent(30) ? 0 : step(left_over, shape_.height);
   const bool left_rises = random_.percent(50);
   fill(pair.left, [&](int x, int y) {
      const int level = (across * x + down * y) & top_;
      return uint16_t(left_rises ? level : top_ - level);
   });
   fill(pair.right, [&](int x, int y) { return uint16_t(top_ - pair.left.at(x, y)); });
   return across;
}

void Painter::rough() {
   const int noise = 1 + random_.below(3 * slopes());
   // Of so many pixels in a hundred: with few of them most costs stay the largest.
   const int some = 5 + random_.below(96);
   for (DeepImage* image : {&pair.left, &pair.right})
      fill(*image, [&](int x, int y) {
         const int level = image->at(x, y);
         return uint16_t(random_.percent(some) ? std::clamp(level + random_.below(2 * noise + 1) - noise, 0, top_)
                                               : level);
      });
}

void Painter::tiles() {
   // As small as they may be to have a place where all of a window and of a census match.
   const int wide = 7 + random_.below(6), high = 6 + random_.below(2), before = random_.below(wide);
   // Bright and dark columns in turn, most of them: one disparity beside the right one the costs are large.
   const int flips = random_.below(30);
   for (DeepImage* image : {&pair.left, &pair.right})
      fill(*image, [&](int x, int) {
         const bool is_dark = (x % 2 == 0) != random_.percent(flips);
         const int level = random_.below(top_ / 2 + 1);
         return uint16_t(is_dark ? level : top_ - level);
      });
   const auto disparity = [&] {
      if (random_.percent(70)) return any_disparity();
      return random_.percent(50) ? last_disparity() : shape_.first_disparity;
   };
   for (int top = 0; top < shape_.height; top += high)
      for (int x = -before; x < shape_.width; x += wide) {
         const int here = disparity();
         for (int y = top; y < std::min(top + high, shape_.height); ++y)
            match(y, std::max(x, 0), std::min(x + wide, shape_.width), here, [](uint16_t v) { return v; });
      }
}

void Painter::contrary() {
   const int wide = 7 + random_.below(8), high = 6 + random_.below(2), before = random_.below(wide);
   const int columns = (before + shape_.width + wide - 1) / wide, rows = (shape_.height + high - 1) / high;
   const bool goes_down = random_.percent(50);
   std::vector<int> all(std::size_t(shape_.disparities));
   std::iota(all.begin(), all.end(), shape_.first_disparity);
   shuffle(all, random_);
   noise(top_ + 1, 1);
   int here = any_disparity();
   for (int i = 0; i < columns * rows; ++i) {
      const int column = goes_down ? i / rows : i % columns, row = goes_down ? i % rows : i / columns;
      const int first = std::max(column * wide - before, 0), end = std::min((column + 1) * wide - before, shape_.width);
      const int other = all[std::size_t(i) % all.size()], period = std::max(1, std::abs(here - other));
      for (int y = row * high; y < std::min((row + 1) * high, shape_.height); ++y) {
         // What lies a period apart is inverted, so the other disparity has the largest costs.
         for (int x = first + period; x < std::min(end + period, shape_.width); ++x)
            pair.right.at(x, y) = uint16_t(top_ - pair.right.at(x - period, y));
         match(y, first, end, here, [](uint16_t v) { return v; });
      }
      // In the next tile the costs turn round, for half of them.
      here = random_.percent(50) ? other : any_disparity();
   }
}

void Painter::bands() {
   const int wide = 2, high = 1 + random_.below(4), shift = random_.below(2 * wide);
   for (DeepImage* image : {&pair.left, &pair.right})
      fill(*image, [&](int x, int y) { return uint16_t((x + shift) / wide % 2 == y / high % 2 ? 0 : top_); });
   const int ends[] = {shape_.first_disparity, shape_.first_disparity + wide, last_disparity() - wide,
                       last_disparity()};
   match_all(random_.percent(70) ? ends[random_.below(4)] : any_disparity());
}

void Painter::enlarged() {
   constexpr int kScale = 4;
   constexpr std::array kKinds{StressClass::steps, StressClass::edges, StressClass::stairs, StressClass::tiles};
   const StressShape shape{(shape_.width + kScale - 1) / kScale, (shape_.height + kScale - 1) / kScale,
                           shape_.first_disparity / kScale, std::max(1, shape_.disparities / kScale),
                           shape_.pixel_bits};
   const DeepPair small = stress_pair(kKinds[std::size_t(random_.below(int(kKinds.size())))], shape, random_);
   const int noise = random_.below(top_ / 16 + 1);
   const auto enlarge = [&](DeepImage& image, const DeepImage& from) {
      fill(image, [&](int x, int y) {
         return uint16_t(std::min(top_, from.at(x / kScale, y / kScale) + random_.below(noise + 1)));
      });
   };
   enlarge(pair.left, small.left);
   enlarge(pair.right, small.right);
}

void Painter::ramp() {
   const int across = 1 + random_.below(8), down = random_.below(6), start = random_.below(top_ + 1);
   const bool saturates = random_.percent(50);
   const auto level = [&](int x, int y) {
      const int value = start + across * x + down * y;
      return uint16_t(saturates ? std::clamp(value, 0, top_) : value & top_);
   };
   const int disparity = any_disparity(), other = random_.percent(50) ? across : 1 + random_.below(8);
   fill(pair.right, level);
   fill(pair.left, [&](int x, int y) { return level((x - disparity + shape_.width) * other / across, y); });
}

void Painter::patchwork() {
   const int columns = 1 + random_.below(3), rows = 1 + random_.below(3);
   for (int row = 0; row < rows; ++row)
      for (int column = 0; column < columns; ++column) {
         const auto kind = kStressClasses[std::size_t(random_.below(int(kStressClasses.size()) - 1))];
         const DeepPair part = stress_pair(kind, shape_, random_);
         for (int y = shape_.height * row / rows; y < shape_.height * (row + 1) / rows; ++y)
            for (int x = shape_.width * column / columns; x < shape_.width * (column + 1) / columns; ++x) {
               pair.left.at(x, y) = part.left.at(x, y);
               pair.right.at(x, y) = part.right.at(x, y);
            }
      }
}

}  // namespace

DeepPair stress_pair(StressClass kind, const StressShape& shape, Random& random) {
   Painter painter(shape, random);
   switch (kind) {
      case StressClass::scene:
         painter.scene();
         break;
      case StressClass::noise:
         painter.noise(1 << shape.pixel_bits, 1);
         break;
      case StressClass::few_levels:
         painter.few_levels();
         break;
      case StressClass::blocks:
         painter.blocks();
         break;
      case StressClass::steps:
         painter.steps(Painter::Jumps::anywhere);
         break;
      case StressClass::edges:
         painter.steps(Painter::Jumps::between_ends);
         break;
      case StressClass::stairs:
         painter.steps(Painter::Jumps::to_neighbours);
         break;
      case StressClass::periodic:
         painter.periodic();
         break;
      case StressClass::constant:
         painter.constant();
         break;
      case StressClass::opposed:
         painter.opposed();
         break;
      case StressClass::slopes:
         painter.slopes();
         break;
      case StressClass::ramp:
         painter.ramp();
         break;
      case StressClass::patchwork:
         painter.patchwork();
         break;
      case StressClass::rough:
         painter.rough();
         break;
      case StressClass::tiles:
         painter.tiles();
         break;
      case StressClass::contrary:
         painter.contrary();
         break;
      case StressClass::bands:
         painter.bands();
         break;
      case StressClass::enlarged:
         painter.enlarged();
         break;
   }
   return std::move(painter.pair);
}

}  // namespace stereo
