// SPDX-License-Identifier: Apache-2.0
#include "program/video/frame_names.hpp"

#include <algorithm>
#include <filesystem>
#include <map>
#include <tuple>

namespace stereo::app {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// A part of a name: a number of any size, or what stands between two.
struct Part {
   bool is_text;
   std::string word;  ///< a number without leading zeros

   bool operator<(const Part& other) const {
      return std::tuple(is_text, is_text ? 0 : word.size(), word) <
             std::tuple(other.is_text, other.is_text ? 0 : other.word.size(), other.word);
   }
};
using Key = std::vector<Part>;

Key parts_of(const std::string& text) {
   Key parts;
   for (std::size_t i = 0; i < text.size();) {
      const bool number = is_digit(text[i]);
      std::size_t end = i;
      while (end < text.size() && is_digit(text[end]) == number) ++end;
      if (number) i = std::min(text.find_first_not_of('0', i), end);
      parts.push_back({!number, text.substr(i, end - i)});
      i = end;
   }
   return parts;
}

std::string stem(const std::string& name) { return std::filesystem::path(name).stem().string(); }

Key whole_name(const std::string& name) { return {{true, name}}; }
Key without_zeros(const std::string& name) { return parts_of(stem(name)); }
Key all_numbers(const std::string& name) {
   Key key = parts_of(stem(name));
   std::erase_if(key, [](const Part& part) { return part.is_text; });
   return key;
}
Key last_number(const std::string& name) {
   const Key key = all_numbers(name);
   return key.empty() ? key : Key{key.back()};
}
Key first_number(const std::string& name) {
   const Key key = all_numbers(name);
   return key.empty() ? key : Key{key.front()};
}

using ByKey = std::map<Key, std::string>;

PairedNames paired(const ByKey& left, const ByKey& right) {
   PairedNames result;
   for (const auto& [key, name] : left) {
      const auto partner = right.find(key);
      if (partner == right.end()) result.left_alone.push_back(name);
      else result.pairs.emplace_back(name, partner->second);
   }
   for (const auto& [key, name] : right)
      if (!left.contains(key)) result.right_alone.push_back(name);
   return result;
}

bool before(const std::string& a, const std::string& b) {
   const Key x = without_zeros(a), y = without_zeros(b);
   return x < y || (!(y < x) && a < b);
}

}  // namespace

void sort_by_number(std::vector<std::string>& names) { std::sort(names.begin(), names.end(), before); }

PairedNames pair_names(const std::vector<std::string>& left, const std::vector<std::string>& right) {
   PairedNames best{{}, left, right};
   bool names_pair = false;
   for (const auto key_of : {whole_name, without_zeros, all_numbers, last_number, first_number}) {
      ByKey of_left, of_right;
      for (const std::string& name : left) of_left.emplace(key_of(name), name);
      for (const std::string& name : right) of_right.emplace(key_of(name), name);
      if (of_left.size() != left.size() || of_right.size() != right.size()) continue;
      PairedNames found = paired(of_left, of_right);
      if (found.pairs.size() <= best.pairs.size()) continue;
      best = std::move(found);
      names_pair = key_of == whole_name;
   }
   if (names_pair)
      std::sort(best.pairs.begin(), best.pairs.end(),
                [](const auto& a, const auto& b) { return before(a.first, b.first); });
   return best;
}

}  // namespace stereo::app
