// SPDX-License-Identifier: Apache-2.0
#include "program/io/plain_yaml.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

#include "scene/random.hpp"
#include "testing/seed.hpp"

namespace stereo::app {
namespace {

std::string json(const std::string& yaml) { return parse_plain_yaml(yaml).dump(); }

TEST(PlainYaml, WhatIsRead) {
   const std::pair<const char*, const char*> cases[] = {
       {"a: 1\nb: two words\n", R"({"a":"1","b":"two words"})"},
       {"%YAML 1.2\n---\na: 1\n...\n", R"({"a":"1"})"},
       {"a:\n  b: 1\n  c:\n    d: x\ne: y\n", R"({"a":{"b":"1","c":{"d":"x"}},"e":"y"})"},
       {"a:\n- 1\n- 2\nb: 3\n", R"({"a":["1","2"],"b":"3"})"},
       {"a:\n  - [1, 2]\n  - [3,\n     4]\n", R"({"a":[["1","2"],["3","4"]]})"},
       {"- - 1\n  - 2\n- - 3\n", R"([["1","2"],["3"]])"},
       {"- a: 1\n  b: 2\n- a: 3\n", R"([{"a":"1","b":"2"},{"a":"3"}])"},
       {"a: {b: [1, 2], c: 'x, y'}\n", R"({"a":{"b":["1","2"],"c":"x, y"}})"},
       {"a: []\nb: {}\nc:\n", R"({"a":[],"b":{},"c":""})"},
       {"# a\na: 1 # b\n\nc: 'x # y'\nd: \"e: f\"\n", R"({"a":"1","c":"x # y","d":"e: f"})"},
       {"a: !!opencv-matrix\n   rows: 1\nb: !!float 2\n", R"({"a":{"rows":"1"},"b":"2"})"},
       {"'a b': it's\nt: /cam0/image_raw\nu: http://x\n", R"({"a b":"it's","t":"/cam0/image_raw","u":"http://x"})"},
       {"a: 1\r\nb: 2\r\n", R"({"a":"1","b":"2"})"},
       {"", R"("")"},
       {"word", R"("word")"},
       {"[1, [2], ]", R"(["1",["2"]])"}};
   for (const auto& [yaml, wanted] : cases) EXPECT_EQ(json(yaml), wanted) << yaml;
}

TEST(PlainYaml, WhatIsRefused) {
   const std::pair<const char*, const char*> cases[] = {{"a: 1\na: 2\n", "line 2: the key a appears twice"},
                                                        {"a: {b: 1, b: 2}\n", "line 1: the key b appears twice"},
                                                        {"a: 1\n---\nb: 2\n", "line 3: there is a second document"},
                                                        {"a: [1, 2\n", "line 1: a bracket is not closed"},
                                                        {"a: 1]\n", "line 1: a bracket is closed"},
                                                        {"a: [1 2}\n", "line 1: a comma or ] is missing"},
                                                        {"a: &x 1\n", "line 1: this kind of value"},
                                                        {"a: *x\n", "line 1: this kind of value"},
                                                        {"a: |\n  text\n", "line 1: this kind of value"},
                                                        {"\ta: 1\n", "line 1: it is indented with a tab"},
                                                        {"a: 1\n  b: 2\n", "line 2: its indentation"},
                                                        {"a: 1\nb\n", "line 2: a key is missing"},
                                                        {"a: 'x\n", "line 1: a quoted text does not end"},
                                                        {"a: [1] 2\n", "line 1: a value is followed by more text"},
                                                        {"a: {b}\n", "line 1: a key has no value"}};
   for (const auto& [yaml, wanted] : cases) try {
         ADD_FAILURE() << yaml << ": " << json(yaml);
      } catch (const std::invalid_argument& problem) {
         EXPECT_EQ(std::string(problem.what()).find(wanted), 0U) << yaml << ": " << problem.what();
      }
   EXPECT_THROW(json(std::string(100, '[') + std::string(100, ']')), std::invalid_argument);
   std::string deep;
   for (int i = 0; i < 100; ++i) deep += std::string(std::size_t(i), ' ') + "a:\n";
   EXPECT_THROW(json(deep), std::invalid_argument);
}

TEST(PlainYaml, SurvivesDamage) {
   Random random(test::test_seed());
   const std::string whole = "a: [1, 2]\nb:\n- {c: 'd'}\n- - e: !t f # g\n    h: i\nj:\n  k: \"l\"\n";
   const std::string characters = " \n\t-:[]{},'\"#!&*|%a1.";
   int taken = 0;
   for (int round = 0; round < 20000; ++round) {
      std::string damaged = whole.substr(0, std::size_t(random.below(int(whole.size()) * 2)));
      for (int i = random.below(6); i > 0 && !damaged.empty(); --i)
         damaged[std::size_t(random.below(int(damaged.size())))] =
             characters[std::size_t(random.below(int(characters.size())))];
      try {
         parse_plain_yaml(damaged);
         ++taken;
      } catch (const std::invalid_argument&) {
         continue;
      }
   }
   EXPECT_GT(taken, 1000);
}

}  // namespace
}  // namespace stereo::app
