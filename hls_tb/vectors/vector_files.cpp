// SPDX-License-Identifier: Apache-2.0
#include "vectors/vector_files.hpp"

#include <array>
#include <charconv>
#include <fstream>
#include <stdexcept>

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
      const std::string value = rest.substr(prefix.size(), end - prefix.size());
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

int hex_digit(char digit) {
   for (int value = 0; value < 16; ++value)
      if (kHexDigits[value] == digit) return value;
   return -1;
}

StereoInput parse_clock(const LineReader& reader, const std::string& line) {
   constexpr std::string_view kForm = "F LL RR";
   std::array<int, kForm.size()> digits{};
   bool good = line.size() == kForm.size();
   for (std::size_t i = 0; good && i < kForm.size(); ++i) {
      digits[i] = hex_digit(line[i]);
      good = kForm[i] == ' ' ? line[i] == ' ' : digits[i] >= 0;
   }
   if (!good || digits[0] > 3) reader.fail("\"" + line + "\" is not of the form \"F LL RR\" with F = 0 ... 3");
   return {.left = uint8_t(digits[2] * 16 + digits[3]),
           .right = uint8_t(digits[5] * 16 + digits[6]),
           .start_of_frame = (digits[0] & 2) != 0,
           .valid = (digits[0] & 1) != 0};
}

CoreOutput parse_output(const LineReader& reader, const std::string& line) {
   std::array<std::string_view, 6> fields;
   std::string_view rest = line;
   for (std::size_t i = 0; i < fields.size(); ++i) {
      const std::size_t blank = rest.find(' ');
      if ((blank == std::string_view::npos) != (i + 1 == fields.size()))
         reader.fail("\"" + line + "\" does not have the six numbers \"clock x y frame disparity flags\"");
      fields[i] = rest.substr(0, blank);
      if (blank != std::string_view::npos) rest.remove_prefix(blank + 1);
   }
   const auto flags = reader.number<unsigned>(fields[5]);
   if (flags > 3) reader.fail("flags are " + std::to_string(flags) + " but must be 0 ... 3");
   return {.clock = reader.number<uint64_t>(fields[0]),
           .x = reader.number<int>(fields[1]),
           .y = reader.number<int>(fields[2]),
           .frame = reader.number<int>(fields[3]),
           .disparity = reader.number<uint8_t>(fields[4]),
           .start_of_frame = (flags & 1) != 0,
           .end_of_line = (flags & 2) != 0};
}

std::ifstream open(const std::string& path) {
   std::ifstream file(path);
   if (!file) throw std::runtime_error(path + ": cannot be read");
   return file;
}

}  // namespace

void write_stimulus(std::ostream& out, const Stimulus& stimulus) {
   out << "stereo-hls stimulus 1 config=" << stimulus.config << " clocks=" << stimulus.clocks.size() << '\n';
   std::string line = "F LL RR\n";
   for (const StereoInput& in : stimulus.clocks) {
      line[0] = kHexDigits[int(in.valid) + 2 * int(in.start_of_frame)];
      line[2] = kHexDigits[in.left / 16];
      line[3] = kHexDigits[in.left % 16];
      line[5] = kHexDigits[in.right / 16];
      line[6] = kHexDigits[in.right % 16];
      out << line;
   }
}

void write_expected(std::ostream& out, const Expected& expected) {
   out << "stereo-hls expected 1 config=" << expected.config << " outputs=" << expected.outputs.size()
       << " latency=" << expected.latency_clocks << '\n';
   for (const CoreOutput& output : expected.outputs)
      out << output.clock << ' ' << output.x << ' ' << output.y << ' ' << output.frame << ' ' << int(output.disparity)
          << ' ' << int(output.start_of_frame) + 2 * int(output.end_of_line) << '\n';
}

Stimulus read_stimulus(std::istream& in, const std::string& name) {
   LineReader reader(in, name);
   std::string rest = reader.header("stereo-hls stimulus 1");
   Stimulus stimulus{reader.field("config", rest), {}};
   const auto count = reader.number<std::size_t>(reader.field("clocks", rest));
   if (!rest.empty()) reader.fail("the first line goes on after clocks=: \"" + rest + "\"");
   for (std::size_t i = 0; i < count; ++i)
      stimulus.clocks.push_back(
          parse_clock(reader, reader.next("clock " + std::to_string(i) + " of " + std::to_string(count))));
   reader.end();
   return stimulus;
}

Expected read_expected(std::istream& in, const std::string& name) {
   LineReader reader(in, name);
   std::string rest = reader.header("stereo-hls expected 1");
   Expected expected{reader.field("config", rest), 0, {}};
   const auto count = reader.number<std::size_t>(reader.field("outputs", rest));
   expected.latency_clocks = reader.number<int>(reader.field("latency", rest));
   if (!rest.empty()) reader.fail("the first line goes on after latency=: \"" + rest + "\"");
   for (std::size_t i = 0; i < count; ++i)
      expected.outputs.push_back(
          parse_output(reader, reader.next("output " + std::to_string(i) + " of " + std::to_string(count))));
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
