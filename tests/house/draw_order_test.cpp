// SPDX-License-Identifier: BSL-1.0
#include <regex>
#include <string>

#include <gtest/gtest.h>

#include "layout.hpp"

/// C++ does not order the operands of a product or the arguments of a call. If two operands or arguments draw from a
/// stream, another compiler may draw other cases.
namespace carom::layout {
namespace {

/// The first unordered pair of draws, or an empty text. `?` and the commas of a braced list do order draws.
std::string unordered_draws(const std::string& text) {
  // Matches two draws in one statement with an operator or a comma between them. A draw is a call of the stream, or of
  // a function that takes the stream. Closing braces or parentheses may follow the first draw.
  static const std::regex pair(
      R"re((stream\.\w+\([^()]*\)|\w+\(stream\b[^()]*\)|stream\.\w+\([^()]*\)[^;?{}()]*\})\)*\s*[-+*/,][^;?{}]*(stream\.\w|\(stream\b))re");
  std::smatch match;
  return std::regex_search(text, match, pair) ? match.str() : std::string();
}

TEST(DrawOrder, IsFoundLackingWherePlanted) {
  for (const char* text :
       {"p = stream.vector() * stream.power_of_two(-2, 2);", "return stream.power_of_two(-6, 6) * (1 + stream.unit());",
        "r = stream.power_of_ten(-18, -1) * (stream.chance(4) ? 1 : -1);",
        "e = (1 + stream.between(0.125, 8)) * (stream.chance(2) ? 1 : -1);",
        "p = stream.vector() *\n    stream.unit();", "x = std::ldexp(stream.unit(), stream.integer(0, 3));",
        "p = turned_across(stream, along, c.normal) * stream.power_of_two(-40, -28);",
        "p = stream.vector() * size_of(stream, c);", "p = V{stream.unit(), 0, 0} * length + stream.vector() * width;",
        "set(drawn(stream, c), stream.unit());"}) {
    EXPECT_NE(unordered_draws(text), "") << text;
  }
}

TEST(DrawOrder, IsNotMissedWhereItIsThere) {
  for (const char* text : {"const double size = stream.power_of_two(-2, 2);\np = stream.vector() * size;",
                           "x = stream.chance(2) ? 1 : stream.unit();", "x = stream.unit() * 2;\ny = stream.unit();",
                           "v[stream.integer(0, 2)] = stream.unit();", "make(stream, c);\nturn(stream, c);",
                           "turn(stream, b, stream.chance(2) ? 1 : -1);"}) {
    EXPECT_EQ(unordered_draws(text), "") << text;
  }
}

TEST(DrawOrder, IsFixedInTheFamilies) {
  int read = 0;
  for (const SourceFile& file : source_files(CAROM_SOURCE_DIR)) {
    if (file.path.starts_with("properties/")) {
      ++read;
      EXPECT_EQ(unordered_draws(file.text), "") << file.path;
    }
  }
  EXPECT_GT(read, 40);
}

}  // namespace
}  // namespace carom::layout
