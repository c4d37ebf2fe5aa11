// SPDX-License-Identifier: BSL-1.0
#include "scene/replay_html.hpp"

#include <stdexcept>

#include <nlohmann/json.hpp>

#include <carom/report/pictures/markup.hpp>

namespace carom::tool {
namespace {

/// The text with each of the `letters` replaced by its counterpart in `written`.
std::string with_letters_as(std::string_view text, std::string_view letters,
                            std::initializer_list<std::string_view> written) {
  std::string result;
  result.reserve(text.size());
  for (const char letter : text) {
    const std::size_t which = letters.find(letter);
    if (which == std::string_view::npos) {
      result += letter;
    } else {
      result += written.begin()[which];
    }
  }
  return result;
}

/// JSON that is safe inside a script element. Only "<" could end the element or begin a comment in it. JSON has "<"
/// only in its strings.
std::string embedded(const nlohmann::json& replay) {
  const std::string text = replay.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  return with_letters_as(text, "<", {"\\u003c"});
}

std::string escaped(std::string_view title) {
  return with_letters_as(report::printable_text(title), "&<>", {"&amp;", "&lt;", "&gt;"});
}

}  // namespace

bool has_replay() { return !replay_page().empty(); }

std::string replay_html(std::string_view title, const nlohmann::json& replay) {
  if (!has_replay()) {
    throw std::logic_error(
        "this program was built without replays; to get them, run `npm ci` in src/tool/replay and build again");
  }
  constexpr std::string_view title_mark = "{{title}}";
  constexpr std::string_view replay_mark = "{{replay}}";
  const std::string_view page = replay_page();
  const std::size_t title_at = page.find(title_mark);
  const std::size_t replay_at = page.find(replay_mark);
  std::string result(page.substr(0, title_at));
  result += escaped(title);
  result += page.substr(title_at + title_mark.size(), replay_at - title_at - title_mark.size());
  result += embedded(replay);
  result += page.substr(replay_at + replay_mark.size());
  return result;
}

}  // namespace carom::tool
