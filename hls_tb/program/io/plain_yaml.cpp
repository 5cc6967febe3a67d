// SPDX-License-Identifier: Apache-2.0
#include "program/io/plain_yaml.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

namespace stereo::app {
namespace {

using Tree = nlohmann::json;

constexpr int kDeepest = 16;  ///< levels; a calibration has four

/// What stands in a line, or in several where a bracket is open.
struct Line {
   int number = 0;
   std::size_t indent = 0;
   std::string text;
};

[[noreturn]] void refuse(int line, const std::string& why) {
   throw std::invalid_argument("line " + std::to_string(line) + ": " + why);
}

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }

std::string_view trimmed(std::string_view text) {
   while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
   while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
   return text;
}

/// Follows the characters of a text: within quotes nothing else counts.
struct Scanner {
   char quote = 0;
   int open = 0;  ///< brackets

   void take(char c, char before) {
      const bool at_start = before == ' ' || before == '\t' || before == '[' || before == '{' || before == ',';
      if (quote != 0) quote = c == quote ? char(0) : quote;
      else if ((c == '"' || c == '\'') && at_start) quote = c;
      else if (c == '[' || c == '{') ++open;
      else if (c == ']' || c == '}') --open;
   }
};

/// Without its comment. `scanner` goes on in the next line.
std::string_view without_comment(std::string_view line, Scanner& scanner) {
   char before = ' ';
   for (std::size_t i = 0; i < line.size(); before = line[i++]) {
      if (line[i] == '#' && scanner.quote == 0 && is_blank(before)) return line.substr(0, i);
      scanner.take(line[i], before);
   }
   return line;
}

bool separates(std::string_view line, std::string_view mark) {
   return line.starts_with(mark) && trimmed(line.substr(mark.size())).empty();
}

std::vector<Line> lines_of(std::string_view text) {
   std::vector<Line> lines;
   Scanner scanner;
   bool ended = false;
   for (int number = 1; !text.empty(); ++number) {
      const std::string_view whole = text.substr(0, text.find('\n'));
      text.remove_prefix(std::min(text.size(), whole.size() + 1));
      const bool goes_on = scanner.open > 0;
      if (!goes_on && (separates(whole, "---") || separates(whole, "..."))) {
         ended = !lines.empty();
         continue;
      }
      if (!goes_on && whole.starts_with('%') && lines.empty()) continue;
      const std::string_view line = without_comment(whole, scanner), content = trimmed(line);
      if (scanner.quote != 0) refuse(number, "a quoted text does not end in its line");
      if (scanner.open < 0) refuse(number, "a bracket is closed that was not opened");
      if (content.empty()) continue;
      if (ended) refuse(number, "there is a second document");
      if (goes_on) {
         lines.back().text.append(" ").append(content);
         continue;
      }
      const std::size_t indent = line.find_first_not_of(' ');
      if (line[indent] == '\t') refuse(number, "it is indented with a tab");
      lines.push_back({number, indent, std::string(content)});
   }
   if (scanner.open > 0) refuse(lines.back().number, "a bracket is not closed");
   return lines;
}

/// A word in quotes as it is meant; escapes stay as they are.
std::string unquoted(std::string_view word) {
   const bool quoted = word.size() >= 2 && (word.front() == '"' || word.front() == '\'') && word.back() == word.front();
   return std::string(quoted ? word.substr(1, word.size() - 2) : word);
}

/// What stands behind a tag as "!!opencv-matrix".
std::string_view without_tag(std::string_view text) {
   if (!text.starts_with('!')) return text;
   return trimmed(text.substr(std::min(text.find(' '), text.size())));
}

/// Where the key of "key: value" ends; npos where there is none.
std::size_t key_end(std::string_view text) {
   Scanner scanner;
   char before = ' ';
   for (std::size_t i = 0; i < text.size(); before = text[i++]) {
      const bool last = i + 1 == text.size() || is_blank(text[i + 1]);
      if (text[i] == ':' && last && scanner.quote == 0 && scanner.open == 0) return i;
      scanner.take(text[i], before);
   }
   return std::string_view::npos;
}

/// [ ], { } and words.
class FlowParser {
  public:
   FlowParser(std::string_view text, int line) : text_(text), line_(line) {}

   Tree whole() {
      Tree tree = value(0);
      if (!rest().empty()) refuse(line_, "a value is followed by more text");
      return tree;
   }

  private:
   std::string_view rest() { return text_ = trimmed(text_); }

   Tree value(int depth) {
      if (depth > kDeepest) refuse(line_, "brackets are nested too deeply");
      text_ = without_tag(rest());
      if (text_.starts_with('[')) return sequence(depth);
      if (text_.starts_with('{')) return mapping(depth);
      return word(depth == 0 ? "" : ",]}");
   }

   /// Up to one of `ends` outside of quotes.
   Tree word(const char* ends) {
      if (!rest().empty() && std::string_view("&*|>@`%").find(text_.front()) != std::string_view::npos)
         refuse(line_, "this kind of value is not known");
      std::size_t end = 0;
      if (!text_.empty() && (text_.front() == '"' || text_.front() == '\'')) {
         end = text_.find(text_.front(), 1);
         if (end == std::string_view::npos) refuse(line_, "a quoted text does not end in its line");
         ++end;
      } else {
         end = std::min(text_.find_first_of(ends), text_.size());
      }
      const std::string_view found = trimmed(text_.substr(0, end));
      text_.remove_prefix(end);
      return unquoted(found);
   }

   bool take(char c) {
      if (!rest().starts_with(c)) return false;
      text_.remove_prefix(1);
      return true;
   }

   Tree sequence(int depth) {
      Tree items = Tree::array();
      take('[');
      while (!take(']')) {
         items.push_back(value(depth + 1));
         if (!take(',') && !rest().starts_with(']')) refuse(line_, "a comma or ] is missing");
      }
      return items;
   }

   Tree mapping(int depth) {
      Tree items = Tree::object();
      take('{');
      while (!take('}')) {
         const std::string key = word(":,]}").get<std::string>();
         if (!take(':')) refuse(line_, "a key has no value");
         if (!items.emplace(key, value(depth + 1)).second) refuse(line_, "the key " + key + " appears twice");
         if (!take(',') && !rest().starts_with('}')) refuse(line_, "a comma or } is missing");
      }
      return items;
   }

   std::string_view text_;
   int line_;
};

class BlockParser {
  public:
   explicit BlockParser(std::vector<Line> lines) : lines_(std::move(lines)) {}

   Tree whole() {
      if (lines_.empty()) return "";
      Tree tree = block(0);
      if (next_ < lines_.size()) refuse(lines_[next_].number, "its indentation does not match the lines before");
      return tree;
   }

  private:
   static bool is_item(const Line& line) { return line.text == "-" || line.text.starts_with("- "); }

   Tree block(int depth) {
      const Line& line = lines_[next_];
      if (depth > kDeepest) refuse(line.number, "it is nested too deeply");
      if (is_item(line)) return sequence(line.indent, depth);
      if (key_end(line.text) != std::string::npos) return mapping(line.indent, depth);
      ++next_;
      return FlowParser(line.text, line.number).whole();
   }

   /// What stands under a line that holds nothing more itself.
   Tree below(std::size_t indent, bool items_may_stand_at_it, int depth) {
      if (next_ == lines_.size()) return "";
      const Line& line = lines_[next_];
      const bool deeper = line.indent > indent || (items_may_stand_at_it && line.indent == indent && is_item(line));
      return deeper ? block(depth + 1) : Tree("");
   }

   Tree sequence(std::size_t indent, int depth) {
      Tree items = Tree::array();
      while (next_ < lines_.size() && lines_[next_].indent == indent && is_item(lines_[next_])) {
         Line& line = lines_[next_];
         const std::size_t behind = line.text.find_first_not_of(" \t", 1);
         if (behind == std::string::npos) {
            ++next_;
            items.push_back(below(indent, false, depth));
            continue;
         }
         line.indent += behind;  // the item's own lines stand as far right as its first
         line.text.erase(0, behind);
         items.push_back(block(depth + 1));
      }
      return items;
   }

   Tree mapping(std::size_t indent, int depth) {
      Tree items = Tree::object();
      while (next_ < lines_.size() && lines_[next_].indent == indent) {
         const Line line = lines_[next_++];
         const std::size_t end = key_end(line.text);
         if (end == std::string::npos || is_item(line)) refuse(line.number, "a key is missing");
         const std::string key = unquoted(trimmed(std::string_view(line.text).substr(0, end)));
         const std::string_view value = without_tag(trimmed(std::string_view(line.text).substr(end + 1)));
         Tree found = value.empty() ? below(indent, true, depth) : FlowParser(value, line.number).whole();
         if (!items.emplace(key, std::move(found)).second) refuse(line.number, "the key " + key + " appears twice");
      }
      return items;
   }

   std::vector<Line> lines_;
   std::size_t next_ = 0;
};

}  // namespace

nlohmann::json parse_plain_yaml(std::string_view text) { return BlockParser(lines_of(text)).whole(); }

}  // namespace stereo::app
