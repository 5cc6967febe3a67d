// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <stdexcept>
#include <vector>

#include "definition/disparity_map.hpp"
#include "definition/gray_image.hpp"
#include "definition/map_geometry.hpp"
#include "engines/option_values.hpp"
#include "scene/random.hpp"

namespace stereo {

/// A way to match, with its options: what the program knows of any family beside its core.
class Algorithm {
  public:
   virtual ~Algorithm() = default;
   virtual std::vector<OptionValue> options() const = 0;
   virtual std::vector<OptionLimits> limits() const = 0;
   /// The same with one option changed; limits are only checked when it matches. Throws std::invalid_argument with what
   /// the value should have been, or with the names of all options.
   virtual std::shared_ptr<const Algorithm> with(const std::string& option, const std::string& value) const = 0;
   /// Why no images can be matched with these options; empty when some can.
   virtual std::string problem() const = 0;
   /// Such as "100 disparities, window 3x3".
   virtual std::string description() const = 0;
   virtual MapGeometry map_geometry(int image_width) const = 0;
   /// The map by the fast model, the same for any number of threads. Throws std::invalid_argument with one sentence
   /// when the pair cannot be matched.
   virtual DisparityMap match_fast(const GrayImage& left, const GrayImage& right, int threads) const = 0;
   /// The same map by the definition; slow.
   virtual DisparityMap match_reference(const GrayImage& left, const GrayImage& right) const = 0;
   /// Of grey values: 8, or what the option pixel_bits says.
   virtual int pixel_bits() const = 0;
   // Both for grey values of up to pixel_bits() bits, where these are more than 8.
   virtual DisparityMap match_fast(const DeepImage& left, const DeepImage& right, int threads) const = 0;
   virtual DisparityMap match_reference(const DeepImage& left, const DeepImage& right) const = 0;
   /// Pairs of this size for the stress stream, beside those of the classes that all families get.
   virtual std::vector<DeepPair> own_stress_pairs(int width, int height, Random& random) const = 0;
};

// The functions of a family's namespace, seen from where no member of the same name hides them.
namespace of_family {
template <class Matching>
std::string description(const Matching& matching) {
   return describe(matching);
}
template <class Matching>
MapGeometry geometry(const Matching& matching, int image_width) {
   return map_geometry(matching, image_width);
}
template <class Image, class Matching>
DisparityMap fast(const Image& left, const Image& right, const Matching& matching, int threads) {
   if constexpr (requires { match_fast(left, right, matching, threads); })
      return match_fast(left, right, matching, threads);
   else return match_fast(left, right, matching);
}
template <class Image, class Matching>
DisparityMap reference(const Image& left, const Image& right, const Matching& matching) {
   return match_reference(left, right, matching);
}
template <class Matching>
std::vector<DeepPair> stress_pairs(const Matching& matching, int width, int height, Random& random) {
   if constexpr (requires { own_stress_pairs(matching, width, height, random); })
      return own_stress_pairs(matching, width, height, random);
   else return {};
}
/// Whether the family has models of pixels of more than 8 bits.
template <class Matching>
inline constexpr bool kIsDeep = requires(const Matching& matching, const DeepImage& image) {
   match_fast(image, image, matching);
   match_reference(image, image, matching);
   matching.pixel_bits;
};
}  // namespace of_family

/// Matching: the options of a family. Its namespace has describe, map_geometry, match_fast and match_reference,
/// and own_stress_pairs where its core needs some.
template <class Matching>
class AlgorithmOf final : public Algorithm {
  public:
   explicit AlgorithmOf(const Matching& matching) : matching_(matching) {}

   std::vector<OptionValue> options() const override { return option_values(matching_); }
   std::vector<OptionLimits> limits() const override { return option_limits(matching_); }
   std::shared_ptr<const Algorithm> with(const std::string& option, const std::string& value) const override {
      Matching changed = matching_;
      set_option(changed, option, value);
      return std::make_shared<AlgorithmOf>(changed);
   }
   std::string problem() const override { return matching_.problem().text; }
   std::string description() const override { return of_family::description(matching_); }
   MapGeometry map_geometry(int image_width) const override { return of_family::geometry(matching_, image_width); }
   DisparityMap match_fast(const GrayImage& left, const GrayImage& right, int threads) const override {
      return of_family::fast(left, right, matching_, threads);
   }
   DisparityMap match_reference(const GrayImage& left, const GrayImage& right) const override {
      return of_family::reference(left, right, matching_);
   }
   int pixel_bits() const override {
      if constexpr (of_family::kIsDeep<Matching>) return matching_.pixel_bits;
      else return 8;
   }
   DisparityMap match_fast(const DeepImage& left, const DeepImage& right, int threads) const override {
      if constexpr (of_family::kIsDeep<Matching>) return of_family::fast(left, right, matching_, threads);
      else throw std::invalid_argument(kOnly8Bits);
   }
   DisparityMap match_reference(const DeepImage& left, const DeepImage& right) const override {
      if constexpr (of_family::kIsDeep<Matching>) return of_family::reference(left, right, matching_);
      else throw std::invalid_argument(kOnly8Bits);
   }
   std::vector<DeepPair> own_stress_pairs(int width, int height, Random& random) const override {
      return of_family::stress_pairs(matching_, width, height, random);
   }

  private:
   static constexpr const char* kOnly8Bits =
       "the images have more than 8 bits a pixel, which this family does not take";

   Matching matching_;
};

}  // namespace stereo
