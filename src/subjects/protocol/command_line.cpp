// SPDX-License-Identifier: BSL-1.0
#include <stdexcept>

#include <carom/subjects/protocol/command_line.hpp>

namespace carom::subjects::protocol {
namespace {

bool is_one_of(char letter, std::string_view letters) { return letters.find(letter) != std::string_view::npos; }

}  // namespace

std::vector<std::string> split_words(std::string_view text) {
  std::vector<std::string> words;
  bool in_word = false;
  char quote = '\0';  // the one that is open, if any
  for (std::size_t at = 0; at < text.size(); ++at) {
    const char letter = text[at];
    // Within double quotes, a backslash escapes only characters that are special there.
    const bool escapes =
        letter == '\\' &&
        (quote == '\0' || (quote == '"' && at + 1 < text.size() && is_one_of(text[at + 1], "$`\"\\\n")));
    if (escapes && ++at == text.size()) {
      throw std::invalid_argument("the command ends with \\; remove it, or double it");
    }
    if (escapes && text[at] == '\n') {
      continue;
    }
    if (quote == '\0' && !escapes && is_one_of(letter, " \t\n")) {
      in_word = false;
      continue;
    }
    if (!in_word) {
      words.emplace_back();
      in_word = true;
    }
    if (escapes) {
      words.back() += text[at];
    } else if (quote == '\0' && is_one_of(letter, "'\"")) {
      quote = letter;
    } else if (letter == quote) {
      quote = '\0';
    } else {
      words.back() += letter;
    }
  }
  if (quote != '\0') {
    throw std::invalid_argument(std::string("a quote is not closed; add ") + quote);
  }
  return words;
}

}  // namespace carom::subjects::protocol
