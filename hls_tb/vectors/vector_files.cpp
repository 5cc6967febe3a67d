// SPDX-License-Identifier: Apache-2.0
#include "vectors/vector_files.hpp"

#include <array>
#include <charconv>
#include <fstream>
#include <stdexcept>

#include "vectors/pixel_word.hpp"

namespace stereo {
namespace {

constexpr char kHexDigits[] = "0123456789abcdef";

/// Reads lines and knows where it is.
class LineReader {
  public:
   LineReader(std::istream& in, std::string name) : in_(in), name_(std::move(name)) {}

   [[noreturn]] void fail(const std::string& what) const {
      throw std::runtime_error(name_ + ":" + std::to_string(number_) + ": " + what);
   }

   const std::string& next(const std::string& wanted) {
      ++number_;
      if (!std::getline(in_, line_)) fail("the file ends where " + wanted + " should stand");
      return line_;
   }

   void end() {
      ++number_;
      if (std::getline(in_, line_)) fail("more lines than the first line announces: \"" + line_ + "\"");
   }

   /// Takes the fields of "<start> key=value key=value ..." off the current line.
   std::string field(const std::string& key, std::string& rest) const {
      const std::string prefix = " " + key + "=";
      if (!rest.starts_with(prefix)) fail("\"" + line_ + "\" has no" + prefix + "<value> where it belongs");
      const std::size_t end = rest.find(' ', prefix.size());
      std::string value = rest.substr(prefix.size(), end - prefix.size());
      rest = end == std::string::npos ? "" : rest.substr(end);
      return value;
   }

   std::string header(const std::string& start) {
      next("the first line");
      if (!line_.starts_with(start + " "))
         fail("the first line must begin with \"" + start + "\", not \"" + line_ + "\"");
      return line_.substr(start.size());
   }

   template <class Number>
   Number number(std::string_view text) const {
      Number value{};
      const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
      if (error != std::errc() || end != text.data() + text.size())
         fail("\"" + std::string(text) + "\" is not a number in range");
      return value;
   }

  private:
   std::istream& in_;
   std::string name_;
   std::string line_;
   int number_ = 0;
};

/// The text of a word of P lanes.
template <class Lane>
std::string word_text(const Lane& lanes, int pixels, int lane_bits) {
   using Value = std::remove_cvref_t<decltype(lanes[0])>;
   const uint64_t word = lane_word<Value>(lanes, pixels, lane_bits);
   std::string text;
   for (int bit = lane_bits * pixels - 4; bit >= 0; bit -= 4) text += kHexDigits[word >> bit & 15];
   return text;
}

/// Sets the lanes; false where the text is not a word of P lanes.
template <class Lanes>
bool parse_word(std::string_view text, int pixels, int lane_bits, Lanes& lanes) {
   using Value = std::remove_cvref_t<decltype(lanes[0])>;
   if (text.size() != std::size_t(pixels * lane_bits / 4) ||
       text.find_first_not_of(kHexDigits) != std::string_view::npos)
      return false;
   uint64_t word = 0;
   std::from_chars(text.data(), text.data() + text.size(), word, 16);
   set_lanes<Value>(lanes, word, pixels, lane_bits);
   return true;
}

int parse_pixels(const LineReader& reader, std::string& rest) {
   const int pixels = reader.number<int>(reader.field("pixels", rest));
   if (pixels != 1 && pixels != 2 && pixels != 4)
      reader.fail("pixels=" + std::to_string(pixels) + " but 1, 2 or 4 pixel pairs can enter in a clock");
   return pixels;
}

int parse_disparity_bits(const LineReader& reader, std::string& rest) {
   const int bits = reader.number<int>(reader.field("disparity_bits", rest));
   if (bits != 8 && bits != 16)
      reader.fail("disparity_bits=" + std::to_string(bits) + " but a disparity takes 8 or 16 bits");
   return bits;
}

StereoInput parse_clock(const LineReader& reader, const std::string& line, int pixels) {
   const std::size_t digits = 2 * std::size_t(pixels), right = digits + 3;
   const std::string_view text = line;
   StereoInput in;
   const bool good = text.size() == right + digits && text[0] >= '0' && text[0] <= '3' && text[1] == ' ' &&
                     text[right - 1] == ' ' && parse_word(text.substr(2, digits), pixels, 8, in.left) &&
                     parse_word(text.substr(right), pixels, 8, in.right);
   if (!good)
      reader.fail("\"" + line + "\" is not of the form \"F " + std::string(digits, 'L') + " " +
                  std::string(digits, 'R') + "\" with F = 0 ... 3");
   in.valid = ((text[0] - '0') & 1) != 0;
   in.start_of_frame = ((text[0] - '0') & 2) != 0;
   return in;
}

CoreOutput parse_output(const LineReader& reader, const std::string& line, int pixels, int disparity_bits) {
   std::array<std::string_view, 6> fields;
   std::string_view rest = line;
   for (std::size_t i = 0; i < fields.size(); ++i) {
      const std::size_t blank = rest.find(' ');
      if ((blank == std::string_view::npos) != (i + 1 == fields.size()))
         reader.fail("\"" + line + "\" does not have the six values \"clock x y frame WORD flags\"");
      fields[i] = rest.substr(0, blank);
      if (blank != std::string_view::npos) rest.remove_prefix(blank + 1);
   }
   const auto flags = reader.number<unsigned>(fields[5]);
   const unsigned most = (4u << pixels) - 1;
   if (flags > most) reader.fail("flags are " + std::to_string(flags) + " but must be 0 ... " + std::to_string(most));
   CoreOutput output{.clock = reader.number<uint64_t>(fields[0]),
                     .x = reader.number<int>(fields[1]),
                     .y = reader.number<int>(fields[2]),
                     .frame = reader.number<int>(fields[3]),
                     .start_of_frame = (flags & 1) != 0,
                     .end_of_line = (flags & 2) != 0};
   set_lanes<bool>(output.pixel_valid, flags >> 2, pixels, 1);
   if (!parse_word(fields[4], pixels, disparity_bits, output.disparity))
      reader.fail("\"" + std::string(fields[4]) + "\" is not a word of " + std::to_string(pixels * disparity_bits / 4) +
                  " hex digits");
   return output;
}

std::ifstream open(const std::string& path) {
   std::ifstream file(path);
   if (!file) throw std::runtime_error(path + ": cannot be read");
   return file;
}

}  // namespace

void write_stimulus(std::ostream& out, const Stimulus& stimulus) {
   const int pixels = stimulus.pixels_per_clock;
   out << "stereo-hls stimulus 1 config=" << stimulus.config << " pixels=" << pixels
       << " clocks=" << stimulus.clocks.size() << '\n';
   for (const StereoInput& in : stimulus.clocks)
      out << int(in.valid) + 2 * int(in.start_of_frame) << ' ' << word_text(in.left, pixels, 8) << ' '
          << word_text(in.right, pixels, 8) << '\n';
}

void write_expected(std::ostream& out, const Expected& expected) {
   const int pixels = expected.pixels_per_clock;
   out << "stereo-hls expected 2 config=" << expected.config << " pixels=" << pixels
       << " disparity_bits=" << expected.disparity_bits << " outputs=" << expected.outputs.size()
       << " latency=" << expected.latency_clocks << '\n';
   for (const CoreOutput& output : expected.outputs)
      out << output.clock << ' ' << output.x << ' ' << output.y << ' ' << output.frame << ' '
          << word_text(output.disparity, pixels, expected.disparity_bits) << ' '
          << unsigned(output.start_of_frame) + 2 * unsigned(output.end_of_line) +
                 4 * lane_word<bool>(output.pixel_valid, pixels, 1)
          << '\n';
}

Stimulus read_stimulus(std::istream& in, const std::string& name) {
   LineReader reader(in, name);
   std::string rest = reader.header("stereo-hls stimulus 1");
   const std::string config = reader.field("config", rest);
   Stimulus stimulus{config, parse_pixels(reader, rest), {}};
   const auto count = reader.number<std::size_t>(reader.field("clocks", rest));
   if (!rest.empty()) reader.fail("the first line goes on after clocks=: \"" + rest + "\"");
   for (std::size_t i = 0; i < count; ++i) {
      const std::string& line = reader.next("clock " + std::to_string(i) + " of " + std::to_string(count));
      stimulus.clocks.push_back(parse_clock(reader, line, stimulus.pixels_per_clock));
   }
   reader.end();
   return stimulus;
}

Expected read_expected(std::istream& in, const std::string& name) {
   LineReader reader(in, name);
   std::string rest = reader.header("stereo-hls expected 2");
   const std::string config = reader.field("config", rest);
   Expected expected{config, parse_pixels(reader, rest), parse_disparity_bits(reader, rest), 0, {}};
   const auto count = reader.number<std::size_t>(reader.field("outputs", rest));
   expected.latency_clocks = reader.number<int>(reader.field("latency", rest));
   if (!rest.empty()) reader.fail("the first line goes on after latency=: \"" + rest + "\"");
   for (std::size_t i = 0; i < count; ++i) {
      const std::string& line = reader.next("output " + std::to_string(i) + " of " + std::to_string(count));
      expected.outputs.push_back(parse_output(reader, line, expected.pixels_per_clock, expected.disparity_bits));
   }
   reader.end();
   return expected;
}

Stimulus read_stimulus_file(const std::string& path) {
   std::ifstream file = open(path);
   return read_stimulus(file, path);
}

Expected read_expected_file(const std::string& path) {
   std::ifstream file = open(path);
   return read_expected(file, path);
}

}  // namespace stereo
