// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cctype>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "layout.hpp"

namespace carom::layout {
namespace {

constexpr std::size_t most_lines = 80;

/// The end of the comment or literal that begins at `begin`; `begin` if there is none.
std::size_t end_of_opaque(const std::string& text, std::size_t begin) {
  const auto after = [&](const std::string& close, std::size_t from) {
    const std::size_t found = text.find(close, from);
    return found == std::string::npos ? text.size() : found + close.size();
  };
  const std::string_view rest = std::string_view(text).substr(begin);
  if (rest.starts_with("//") || (rest.starts_with('#') && (begin == 0 || text[begin - 1] == '\n'))) {
    return after("\n", begin) - 1;
  }
  if (rest.starts_with("/*")) {
    return after("*/", begin + 2);
  }
  if (rest.starts_with("R\"")) {
    const std::size_t open = text.find('(', begin);
    return after(')' + text.substr(begin + 2, open - begin - 2) + '"', open);
  }
  // An apostrophe between digits is a digit separator.
  const bool is_character = rest.starts_with('\'') && (begin == 0 || std::isalnum(text[begin - 1]) == 0);
  if (!rest.starts_with('"') && !is_character) {
    return begin;
  }
  std::size_t end = begin + 1;
  while (end < text.size() && text[end] != text[begin]) {
    end += text[end] == '\\' ? 2 : 1;
  }
  return end + 1;
}

/// The text with every character of a comment, a literal or a directive replaced by a space.
std::string without_opaque(std::string text) {
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t end = std::min(end_of_opaque(text, i), text.size());
    for (std::size_t k = i; k < end; ++k) {
      text[k] = text[k] == '\n' ? '\n' : ' ';
    }
    i = std::max(end, i + 1);
  }
  return text;
}

bool is_head_of_function(std::string_view head) {
  for (const char* other : {"namespace", "class ", "struct ", "enum ", "union "}) {
    if (head.starts_with(other)) {
      return false;
    }
  }
  return head.find(')') != std::string_view::npos;
}

std::size_t lines_in(std::string_view text) {
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

/// The number of lines of the statement that returns a table, if the body `{…` ends with such a statement; else 0. A
/// table is no code. Functions in its rows are measured separately.
std::size_t lines_of_returned_table(std::string_view body) {
  int depth = 0;
  std::size_t last = 1;
  std::size_t next = 1;
  for (std::size_t i = 1; i < body.size(); ++i) {
    depth += body[i] == '{' || body[i] == '(' ? 1 : body[i] == '}' || body[i] == ')' ? -1 : 0;
    const std::size_t after = body.find_first_not_of(" \n", i + 1);
    const bool ends_block = body[i] == '}' && (after == std::string_view::npos || std::isalpha(body[after]) != 0);
    if (depth == 0 && (body[i] == ';' || ends_block)) {
      last = std::exchange(next, i + 1);
    }
  }
  const std::string_view statement = body.substr(std::min(body.find_first_not_of(" \n", last), body.size()));
  return statement.starts_with("return") ? lines_in(statement) : 0;
}

/// The declarations, without parameters, of the functions with more than `most` lines.
std::vector<std::string> long_functions(const std::string& source, std::size_t most) {
  const std::string text = without_opaque(source);
  const auto next_from = [&](std::size_t from) { return std::min(text.find_first_not_of(" \n", from), text.size()); };
  const auto ends_statement = [&](std::size_t i) {
    if (text[i] == ':') {
      const std::string_view before = std::string_view(text).substr(0, i);
      return before.ends_with("public") || before.ends_with("private") || before.ends_with("protected");
    }
    return text[i] == '{' || text[i] == '}' || text[i] == ';';
  };
  std::vector<std::string> found;
  std::vector<std::size_t> heads;  // where the declaration of each open block begins
  std::size_t head = next_from(0);
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '{') {
      heads.push_back(head);
    }
    if (ends_statement(i)) {
      head = next_from(i + 1);
    }
    if (text[i] == '}' && !heads.empty()) {
      const std::size_t begin = heads.back();
      heads.pop_back();
      const std::string_view block = std::string_view(text).substr(begin, i - begin);
      const std::string_view declaration = block.substr(0, block.find('{'));
      const std::string_view body = block.substr(declaration.size());
      const std::size_t lines = lines_in(block) + 1 - lines_of_returned_table(body);
      if (lines > most && is_head_of_function(declaration)) {
        found.emplace_back(declaration.substr(0, declaration.find('(')));
      }
      // After a member initializer, name{…}, the constructor's head continues.
      const bool is_initializer = !declaration.empty() && declaration.back() != ' ';
      if (is_initializer && head < text.size() && (text[head] == ',' || text[head] == '{')) {
        head = begin;
      }
    }
  }
  return found;
}

std::string function_of_lines(const std::string& head, int lines) {
  std::string text = head + " {\n";
  for (int i = 2; i < lines; ++i) {
    text += "  f();\n";
  }
  return text + "}\n";
}

TEST(LongFunctions, AreFoundFromTheFirstLineTooMuch) {
  for (const char* head : {"int f(int x)", "void A::f() const noexcept", "A::A()\n    : a_(1),\n      b_{2}",
                           "template <class T>\nT f()", "const auto f = [](int x)"}) {
    const int more = static_cast<int>(std::count(head, head + std::string_view(head).size(), '\n'));
    EXPECT_EQ(long_functions(function_of_lines(head, 8 - more), 8).size(), 0U) << head;
    EXPECT_EQ(long_functions("int x;\n// why\n" + function_of_lines(head, 9 - more), 8).size(), 1U) << head;
  }
  EXPECT_EQ(long_functions("namespace n {\nstruct A {\n" + function_of_lines("int f(int x)", 9) + "};\n}\n", 8),
            std::vector<std::string>{"int f"});
}

TEST(LongFunctions, AreNoTableNoClassAndNoText) {
  for (const char* head :
       {"namespace n", "class A", "struct A", "enum class A", "constexpr std::array table{1, 2},\n  b"}) {
    EXPECT_EQ(long_functions(function_of_lines(head, 9), 8).size(), 0U) << head;
  }
  EXPECT_EQ(long_functions("const char* text = R\"x(" + function_of_lines("f()", 9) + ")x\";\n", 8).size(), 0U);
}

TEST(LongFunctions, AreNoTableThatIsReturned) {
  const std::string row = "[](int x) {\n f();\n f();\n return x; }";
  const auto rows = [&](int count) {
    std::string text;
    for (int i = 0; i < count; ++i) {
      text += row + ",\n";
    }
    return text;
  };
  EXPECT_EQ(long_functions("std::vector<F> all() {\n  return {" + rows(5) + "};\n}\n", 8).size(), 0U);
  EXPECT_EQ(long_functions("std::vector<F> all() {\n  return {" + rows(5) + "};\n}\n", 3).size(), 5U) << "the rows";
  EXPECT_EQ(long_functions("std::vector<F> all() {\n  f();\n  return {" + rows(5) + "};\n}\n", 8).size(), 0U);
  EXPECT_EQ(long_functions(
                "std::vector<F> all() {\n" + function_of_lines("  if (x)", 9) + "  return {" + rows(5) + "};\n}\n", 9)
                .size(),
            1U);
  EXPECT_EQ(long_functions("int f() {\n  return g();\n" + function_of_lines("  if (x)", 9) + "}\n", 9).size(), 1U);
}

TEST(LongFunctions, AreMeasuredWhateverBracesLiteralsHave) {
  for (const char* line : {"  f(\"}\");\n", "  f('}');\n", "  // }\n", "  f(1'000 + '}' + 2'000);\n",
                           "  f(\"\\\"}\");\n", "  f(R\"(\"})\");\n", "  /* } */\n"}) {
    std::string text = function_of_lines("int f()", 8);
    text.insert(text.find("  f"), line);
    EXPECT_EQ(long_functions(text, 8).size(), 1U) << line;
  }
}

TEST(Layout, HasAShortMain) {
  for (const SourceFile& file : source_files(CAROM_SOURCE_DIR)) {
    EXPECT_TRUE(!file.path.ends_with("/main.cpp") || lines_in(file.text) < 60) << file.path;
  }
}

TEST(Layout, HasNoFunctionOfMoreThanEightyLines) {
  std::set<std::string> found;
  for (const SourceFile& file : source_files(CAROM_SOURCE_DIR)) {
    const bool is_cpp = file.path.ends_with(".cpp") || file.path.ends_with(".hpp");
    if (is_cpp && !file.path.starts_with("tests/") && !file.path.starts_with("docs/")) {
      for (const std::string& function : long_functions(file.text, most_lines)) {
        found.insert(file.path + ": " + function);
      }
    }
  }
  EXPECT_EQ(found, std::set<std::string>{});
}

}  // namespace
}  // namespace carom::layout
