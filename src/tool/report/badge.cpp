// SPDX-License-Identifier: BSL-1.0
#include "report/badge.hpp"

#include <sstream>

#include <fmt/format.h>
#include <pugixml.hpp>

#include "report/markup.hpp"

namespace carom::tool {
namespace {

constexpr int height = 20;
constexpr int margin = 6;        // of a text in its field
constexpr int letter_width = 7;  // to which each text is fitted, whatever the font

constexpr const char* label = "carom";
constexpr const char* label_colour = "#444444";

/// White letters have a contrast of at least 4.5 on each of these (WCAG 2.1, 1.4.3).
const char* colour_of(const std::string& verdict) {
  if (verdict == "sound") {
    return "#1e7b34";
  }
  return verdict == "not judged" ? "#6a6a6a" : "#b3261e";
}

int width_of(const std::string& text) { return letter_width * static_cast<int>(text.size()) + 2 * margin; }

void add_field(pugi::xml_node picture, int left, const std::string& text, const char* colour) {
  const std::string x = fmt::format("{}", left);
  const std::string width = fmt::format("{}", width_of(text));
  add(picture, "rect",
      {{"x", x}, {"y", "0"}, {"width", width}, {"height", fmt::format("{}", height)}, {"fill", colour}});
  add(picture, "text",
      {{"x", fmt::format("{}", left + margin)},
       {"y", "14"},
       {"textLength", fmt::format("{}", width_of(text) - 2 * margin)},
       {"lengthAdjust", "spacingAndGlyphs"}},
      text);
}

}  // namespace

std::string badge_svg(const Overall& overall) {
  const std::string verdict = in_words(overall);
  const std::string title = fmt::format("{}: {}", label, verdict);
  const std::string width = fmt::format("{}", width_of(label) + width_of(verdict));
  pugi::xml_document document;
  const pugi::xml_node picture = add(document.root(), "svg",
                                     {{"xmlns", "http://www.w3.org/2000/svg"},
                                      {"width", width},
                                      {"height", fmt::format("{}", height)},
                                      {"viewBox", fmt::format("0 0 {} {}", width, height)},
                                      {"role", "img"},
                                      {"aria-label", title},
                                      {"font-family", "Verdana, DejaVu Sans, sans-serif"},
                                      {"font-size", "11"},
                                      {"fill", "#ffffff"}});
  add(picture, "title", {}, title);
  add_field(picture, 0, label, label_colour);
  add_field(picture, width_of(label), verdict, colour_of(verdict));
  std::ostringstream text;
  document.save(text, "  ");
  return text.str();
}

}  // namespace carom::tool
