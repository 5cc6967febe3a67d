// SPDX-License-Identifier: Apache-2.0
// Options are declared in groups, each option once: its member, its line in the group's list `options`
// (support/options.hpp), and what must hold for it beside its limits:
//
//    struct Prefiltering {
//       Prefilter prefilter = Prefilter::none;
//       int prefilter_cap = 31;
//
//       template <class Self, class Visitor>
//       static constexpr void options(Self& self, Visitor& visit);  // self: all options of the family
//       template <class Self>
//       static constexpr Sentence missing(const Self& self);        // optional: what must be there for it at all
//       template <class Self>
//       static constexpr Sentence problem(const Self& self);        // optional: what else is wrong within the limits
//    };
//
// A family has a list of groups, and its options are given by groups in any order:
//
//    struct Matching : OptionGroups<DisparityCount, Default<MatchingWindow{9}>, Prefiltering> {
//       using OptionGroups::OptionGroups;
//    };
//    Matching matching{MatchingWindow{5}, Prefiltering{.prefilter_cap = 63}};
#pragma once

#include <type_traits>

#include "support/options.hpp"
#include "support/sentence.hpp"

namespace stereo {

/// A group with other defaults than its own: a family's. Only for groups of one option, since a group that is given
/// replaces all of it.
template <auto Standard>
struct Default : std::remove_const_t<decltype(Standard)> {
   using Group = std::remove_const_t<decltype(Standard)>;

   constexpr Default() : Group(Standard) {}
};

template <class... Groups>
struct OptionGroups : Groups... {
   constexpr OptionGroups() = default;
   template <class... Given>
      requires(sizeof...(Given) > 0 && (std::is_base_of_v<Given, OptionGroups> && ...))
   constexpr OptionGroups(const Given&... given) {
      (give(given), ...);
   }

   template <class Self, class Visitor>
   static constexpr void options(Self& self, Visitor& visit) {
      (Groups::options(self, visit), ...);
   }

   /// Takes over each group that `other` has, too.
   template <class Other>
   constexpr void share(const Other& other) {
      (share_group<Groups>(other), ...);
   }

  protected:
   /// Why the options do not fit together, by their groups alone; empty when they do.
   template <class Self>
   static constexpr Sentence problem_of(const Self& self) {
      Sentence problem;
      static_cast<void>(((problem = missing_for<Groups>(self), !problem.empty()) || ...));
      if (problem.empty()) problem = first_beyond_limits(self);
      if (problem.empty()) static_cast<void>(((problem = problem_in<Groups>(self), !problem.empty()) || ...));
      return problem;
   }

  private:
   template <class Group>
   constexpr void give(const Group& group) {
      static_cast<Group&>(*this) = group;
   }
   template <class Group, class Other>
   constexpr void share_group(const Other& other) {
      if constexpr (requires { typename Group::Group; }) share_group<typename Group::Group>(other);
      else if constexpr (std::is_base_of_v<Group, Other>) give<Group>(other);
   }
   template <class Group, class Self>
   static constexpr Sentence missing_for(const Self& self) {
      if constexpr (requires { Group::missing(self); }) return Group::missing(self);
      else return {};
   }
   template <class Group, class Self>
   static constexpr Sentence problem_in(const Self& self) {
      if constexpr (requires { Group::problem(self); }) return Group::problem(self);
      else return {};
   }
};

/// The options of another family, or of another kind, as far as both have their groups; its own defaults else.
template <class Other, class Options>
constexpr Other shared_options(const Options& options) {
   Other other;
   other.share(options);
   return other;
}

}  // namespace stereo
