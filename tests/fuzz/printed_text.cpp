// SPDX-License-Identifier: BSL-1.0
// The first byte is the greatest printed length. The rest is the text.
#include <algorithm>
#include <stdexcept>
#include <string>

#include <nlohmann/json.hpp>

#include <carom/collision/json/text.hpp>
#include <carom/subjects/protocol/command_line.hpp>

#include "target.hpp"

namespace carom::fuzz {
namespace {

namespace protocol = subjects::protocol;

constexpr std::string_view ellipsis = "…";
constexpr std::size_t longest_replacement = 3;  // of a byte that is not UTF-8

bool is_utf8(const std::string& text) {
  try {
    (void)nlohmann::json(text).dump();
    return true;
  } catch (const nlohmann::json::exception&) {
    return false;
  }
}

bool is_control(char letter) { return static_cast<unsigned char>(letter) < 0x20 || letter == 0x7f; }

void print(const std::string& text, std::size_t longest) {
  const std::string shown = carom::printable(text, longest);
  require(is_utf8(shown), "what is printed is not UTF-8");
  require(shown.size() <= longest_replacement * longest + ellipsis.size(), "more is printed than may be");
  require(std::none_of(shown.begin(), shown.end(),
                       [](char letter) { return is_control(letter) && letter != '\n' && letter != '\t'; }),
          "a control character is printed");
  for (const char* turning :
       {"\u061c", "\u200e", "\u200f", "\u2028", "\u202a", "\u202e", "\u2066", "\u2069", "\u0085", "\u009b"}) {
    require(shown.find(turning) == std::string::npos, "what turns the writing is printed");
  }
  const std::string line = carom::printable_line(text, longest);
  require(std::none_of(line.begin(), line.end(), is_control), "a line is printed that is none");
}

void split(const std::string& text) {
  require(protocol::split_words(carom::quoted(text)) == std::vector<std::string>{text},
          "a quoted word is not read back");
  try {
    std::string line;
    const std::vector<std::string> words = protocol::split_words(text);
    for (const std::string& word : words) {
      line += carom::quoted(word) + ' ';
    }
    require(protocol::split_words(line) == words, "quoted words are not read back");
  } catch (const std::invalid_argument&) {
    return;
  }
}

}  // namespace
}  // namespace carom::fuzz

CAROM_FUZZ_TARGET(printed_text) {
  carom::fuzz::Input input({data, size});
  const std::size_t longest = input.byte();
  const std::string text(input.text());
  carom::fuzz::print(text, longest);
  carom::fuzz::split(text);
  return 0;
}
