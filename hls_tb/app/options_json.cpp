// SPDX-License-Identifier: Apache-2.0
#include "app/options_json.hpp"

#include <algorithm>
#include <charconv>
#include <span>

#include "app/errors.hpp"

namespace stereo::app {
namespace {

template <class Value>
struct Word {
   Value value;
   const char* word;
};

constexpr Word<Reference> kReferences[] = {{Reference::left, "left"}, {Reference::right, "right"}};
constexpr Word<Cost> kCosts[] = {{Cost::sad, "sad"}, {Cost::ssd, "ssd"}, {Cost::census, "census"}};
constexpr Word<Prefilter> kPrefilters[] = {{Prefilter::none, "none"}, {Prefilter::xsobel, "xsobel"}};
constexpr Word<Ties> kTies[] = {{Ties::smallest, "smallest"}, {Ties::largest, "largest"}};
constexpr Word<bool> kFlags[] = {{false, "false"}, {true, "true"}};

std::span<const Word<Reference>> words(Reference) { return kReferences; }
std::span<const Word<Cost>> words(Cost) { return kCosts; }
std::span<const Word<Prefilter>> words(Prefilter) { return kPrefilters; }
std::span<const Word<Ties>> words(Ties) { return kTies; }
std::span<const Word<bool>> words(bool) { return kFlags; }

/// Calls visit(name, member) for each option. Options: MatchingParameters, const or not.
template <class Options, class Visit>
void for_each_option(Options& options, Visit visit) {
   visit("disparities", options.disparities);
   visit("window_px", options.window_px);
   visit("min_disparity", options.min_disparity);
   visit("reference", options.reference);
   visit("cost", options.cost);
   visit("census_width_px", options.census_width_px);
   visit("census_height_px", options.census_height_px);
   visit("prefilter", options.prefilter);
   visit("prefilter_cap", options.prefilter_cap);
   visit("ties", options.ties);
   visit("left_right_threshold", options.left_right_threshold);
   visit("uniqueness_percent", options.uniqueness_percent);
   visit("texture_threshold", options.texture_threshold);
   visit("subpixel", options.subpixel);
   visit("median", options.median);
}

nlohmann::json json_of(int value) { return value; }
nlohmann::json json_of(bool value) { return value; }
template <class Value>
nlohmann::json json_of(Value value) {
   for (const auto& entry : words(value))
      if (entry.value == value) return entry.word;
   return nullptr;
}

/// Returns what the text should have been, or nothing when it was taken.
std::string take(const std::string& text, int& value) {
   const char* const end = text.data() + text.size();
   int number = 0;
   const auto [rest, error] = std::from_chars(text.data(), end, number);
   if (error != std::errc() || rest != end || text.empty()) return "a whole number";
   value = number;
   return "";
}

template <class Value>
std::string take(const std::string& text, Value& value) {
   std::string known;
   for (const auto& entry : words(value)) {
      if (text == entry.word) {
         value = entry.value;
         return "";
      }
      known += (known.empty() ? "" : " or ") + std::string(entry.word);
   }
   return known;
}

void set_option(MatchingParameters& options, const std::string& key_and_value) {
   const std::size_t equals = key_and_value.find('=');
   if (equals == std::string::npos)
      throw InputError("--set " + key_and_value + ": must be NAME=VALUE, such as window_px=9");
   const std::string key = key_and_value.substr(0, equals), text = key_and_value.substr(equals + 1);
   bool found = false;
   std::string known;
   for_each_option(options, [&](const char* name, auto& value) {
      known += (known.empty() ? "" : ", ") + std::string(name);
      if (key != name) return;
      found = true;
      const std::string wanted = take(text, value);
      if (!wanted.empty()) throw InputError("--set " + key_and_value + ": the value must be " + wanted);
   });
   if (!found) throw InputError("--set " + key_and_value + ": there is no such option; known are: " + known);
}

}  // namespace

const char* word_of(Reference reference) {
   return std::ranges::find(kReferences, reference, &Word<Reference>::value)->word;
}

const std::map<std::string, Reference>& reference_words() {
   static const std::map<std::string, Reference> words = [] {
      std::map<std::string, Reference> made;
      for (const auto& [value, word] : kReferences) made[word] = value;
      return made;
   }();
   return words;
}

nlohmann::json options_json(const MatchingParameters& options) {
   nlohmann::json json;
   for_each_option(options, [&json](const char* name, const auto& value) { json[name] = json_of(value); });
   return json;
}

MatchingParameters with_options(MatchingParameters options, const std::vector<std::string>& settings) {
   for (const std::string& setting : settings) set_option(options, setting);
   return options;
}

}  // namespace stereo::app
