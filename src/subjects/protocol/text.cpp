// SPDX-License-Identifier: BSL-1.0
#include <nlohmann/json.hpp>

#include <carom/subjects/protocol/text.hpp>

namespace carom::subjects::protocol {

std::string printable(std::string text, std::size_t longest) {
  const bool is_long = text.size() > longest;
  text.resize(std::min(text.size(), longest));
  for (char& letter : text) {
    const auto code = static_cast<unsigned char>(letter);
    const bool is_control = code < 0x20 || code == 0x7f;
    letter = is_control && letter != '\n' && letter != '\t' ? '?' : letter;
  }
  using nlohmann::json;
  const std::string valid = json(text).dump(-1, ' ', false, json::error_handler_t::replace);
  return json::parse(valid).get<std::string>() + (is_long ? "…" : "");
}

}  // namespace carom::subjects::protocol
