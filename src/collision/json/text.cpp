// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cctype>
#include <string_view>
#include <utility>

#include <nlohmann/json.hpp>

#include <carom/collision/json/text.hpp>

namespace carom {
namespace {

std::string valid_utf8(const std::string& text) {
  using nlohmann::json;
  return json::parse(json(text).dump(-1, ' ', false, json::error_handler_t::replace)).get<std::string>();
}

/// The length in bytes of a control character of several bytes at the start of the text; otherwise 0. C1 controls
/// (U+0080 to U+009F) drive terminals as ESC does. U+061C, U+200E, U+200F, U+202A to U+202E and U+2066 to U+2069 change
/// the direction of writing. U+2028 and U+2029 end lines.
std::size_t long_control(std::string_view text) {
  const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U; };
  if ((byte(0) == 0xc2 && byte(1) >= 0x80 && byte(1) <= 0x9f) || (byte(0) == 0xd8 && byte(1) == 0x9c)) {
    return 2;
  }
  const bool is_mark = byte(2) == 0x8e || byte(2) == 0x8f;
  const bool is_embedding_or_end = byte(2) >= 0xa8 && byte(2) <= 0xae;
  const bool is_isolate = byte(2) >= 0xa6 && byte(2) <= 0xa9;
  const bool turns = (byte(1) == 0x80 && (is_mark || is_embedding_or_end)) || (byte(1) == 0x81 && is_isolate);
  return byte(0) == 0xe2 && turns ? 3 : 0;
}

}  // namespace

std::string printable(std::string text, std::size_t longest) {
  const bool is_long = text.size() > longest;
  text.resize(std::min(text.size(), longest));
  text = valid_utf8(text);
  std::string result;
  for (std::size_t i = 0; i < text.size();) {
    const auto code = static_cast<unsigned char>(text[i]);
    const bool is_control = (code < 0x20 && text[i] != '\n' && text[i] != '\t') || code == 0x7f;
    const std::size_t control = is_control ? 1 : long_control(std::string_view(text).substr(i));
    result += control > 0 ? '?' : text[i];
    i += std::max<std::size_t>(control, 1);
  }
  return result + (is_long ? "…" : "");
}

std::string printable_line(std::string text, std::size_t longest) {
  std::replace_if(
      text.begin(), text.end(), [](char letter) { return letter == '\n' || letter == '\t'; }, ' ');
  return printable(std::move(text), longest);
}

std::string quoted(const std::string& word) {
  const auto is_plain = [](char letter) {
    return std::isalnum(static_cast<unsigned char>(letter)) != 0 ||
           std::string_view("-._/").find(letter) != std::string_view::npos;
  };
  if (!word.empty() && std::all_of(word.begin(), word.end(), is_plain)) {
    return word;
  }
  std::string result = "'";
  for (const char letter : word) {
    result += letter == '\'' ? std::string("'\\''") : std::string(1, letter);
  }
  return result + '\'';
}

}  // namespace carom
