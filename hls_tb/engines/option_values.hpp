// SPDX-License-Identifier: Apache-2.0
// Options (support/options.hpp) by name at run time.
#pragma once

#include <charconv>
#include <iterator>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include "support/options.hpp"

namespace stereo {

struct OptionValue {
   std::string name;
   std::variant<int, bool, std::string> value;  ///< a number, a flag, or the word of a choice

   bool operator==(const OptionValue&) const = default;
};

/// The visitor that reads all options of a list.
struct OptionReader {
   std::vector<OptionValue> values;

   void operator()(const char* name, int value, int, int, const char*) { values.push_back({name, value}); }
   template <class Choice>
   void operator()(const char* name, const Choice& value) {
      if constexpr (std::is_same_v<Choice, bool>) values.push_back({name, value});
      else values.push_back({name, std::string(Words<Choice>::kWords[std::size_t(value)])});
   }
};

template <class Options>
std::vector<OptionValue> option_values(const Options& options) {
   OptionReader reader;
   Options::options(options, reader);
   return std::move(reader.values);
}

/// What is known of an option beside its value.
struct OptionLimits {
   OptionValue standard;            ///< the value of an option that is not given
   std::optional<int> low, high;    ///< of a number; limits that follow from other options are those of their defaults
   std::vector<std::string> words;  ///< of a choice or a flag
   std::string meaning;             ///< of a number: "the window side"
};

/// The visitor that reads all options of a list with their limits.
struct LimitReader {
   std::vector<OptionLimits> limits;

   void operator()(const char* name, int value, int low, int high, const char* meaning) {
      const auto limit = [](int number) {
         const bool none = number == kUnlimited || number == -kUnlimited - 1;
         return none ? std::nullopt : std::optional<int>(number);
      };
      limits.push_back({{name, value}, limit(low), limit(high), {}, meaning});
   }
   template <class Choice>
   void operator()(const char* name, const Choice& value) {
      OptionReader reader;
      reader(name, value);
      limits.push_back(
          {reader.values.front(), {}, {}, {std::begin(Words<Choice>::kWords), std::end(Words<Choice>::kWords)}, ""});
   }
};

template <class Options>
std::vector<OptionLimits> option_limits(const Options& options) {
   LimitReader reader;
   Options::options(options, reader);
   return std::move(reader.limits);
}

/// The visitor that gives the option of one name a value. Limits are checked later, when all are given.
struct OptionSetter {
   const std::string& name;
   const std::string& text;
   bool found = false;  ///< there is such an option
   std::string wanted;  ///< what the text should have been; empty when it was taken
   std::string known;   ///< all names

   OptionSetter(const std::string& option, const std::string& value) : name(option), text(value) {}

   void operator()(const char* option, int& value, int, int, const char*) {
      if (!is(option)) return;
      const char* const end = text.data() + text.size();
      int number = 0;
      const auto [rest, error] = std::from_chars(text.data(), end, number);
      if (error != std::errc() || rest != end || text.empty()) wanted = "a whole number";
      else value = number;
   }
   template <class Choice>
   void operator()(const char* option, Choice& value) {
      if (!is(option)) return;
      for (std::size_t i = 0; i < std::size(Words<Choice>::kWords); ++i) {
         if (text == Words<Choice>::kWords[i]) {
            value = Choice(i);
            wanted.clear();
            return;
         }
         wanted += (wanted.empty() ? "" : " or ") + std::string(Words<Choice>::kWords[i]);
      }
   }

  private:
   bool is(const char* option) {
      known += (known.empty() ? "" : ", ") + std::string(option);
      found = found || name == option;
      return name == option;
   }
};

/// Gives the option of a name a value. Throws std::invalid_argument with what the value should have been, or with the
/// names of all options. Limits are checked later.
template <class Options>
void set_option(Options& options, const std::string& name, const std::string& value) {
   OptionSetter setter(name, value);
   Options::options(options, setter);
   if (!setter.found) throw std::invalid_argument("there is no such option; known are: " + setter.known);
   if (!setter.wanted.empty()) throw std::invalid_argument("the value must be " + setter.wanted);
}

}  // namespace stereo
