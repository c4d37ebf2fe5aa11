// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cctype>
#include <map>
#include <string>

#include <carom/report/pictures/markup.hpp>

namespace carom::report {
namespace {

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }
bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

struct Symbol {
  const char* element;
  std::string_view text;
};

const std::map<std::string_view, Symbol>& symbols() {
  static const std::map<std::string_view, Symbol> all{
      {"cdot", {"mo", "·"}},  {"ge", {"mo", "≥"}},         {"le", {"mo", "≤"}},     {"Rightarrow", {"mo", "⇒"}},
      {"times", {"mo", "×"}}, {"preceq", {"mo", "⪯"}},     {"in", {"mo", "∈"}},     {"sum", {"mo", "∑"}},
      {"top", {"mo", "⊤"}},   {"partial", {"mi", "∂"}},    {"eta", {"mi", "η"}},    {"mu", {"mi", "μ"}},
      {"max", {"mi", "max"}}, {"varepsilon", {"mi", "ε"}}, {"lambda", {"mi", "λ"}}, {"Delta", {"mi", "Δ"}},
      {"min", {"mi", "min"}}, {"parallel", {"mo", "∥"}},   {"omega", {"mi", "ω"}},  {"ne", {"mo", "≠"}},
      {"to", {"mo", "→"}},    {"pm", {"mo", "±"}},         {"lor", {"mo", "∨"}},
  };
  return all;
}

class LatexReader {
 public:
  explicit LatexReader(std::string_view rest) : rest_(rest) {}

  void row_into(pugi::xml_node parent) {
    while (!rest_.empty() && rest_.front() != '}') {
      if (rest_.front() == ' ') {
        rest_.remove_prefix(1);
      } else {
        scripted_into(parent);
      }
    }
  }

 private:
  /// Appends an atom with its subscript and its superscript.
  void scripted_into(pugi::xml_node parent) {
    const pugi::xml_node atom = atom_into(parent);
    pugi::xml_document scripts;
    const pugi::xml_node below = scripts.append_child("mrow");
    const pugi::xml_node above = scripts.append_child("mrow");
    while (!rest_.empty() && (rest_.front() == '^' || rest_.front() == '_')) {
      const bool is_above = rest_.front() == '^';
      rest_.remove_prefix(1);
      argument_into(is_above ? above : below);
    }
    const bool has_below = static_cast<bool>(below.first_child());
    const bool has_above = static_cast<bool>(above.first_child());
    if (has_below || has_above) {
      pugi::xml_node whole = parent.append_child(has_below && has_above ? "msubsup" : (has_below ? "msub" : "msup"));
      whole.append_move(atom);
      if (has_below) {
        whole.append_copy(below);
      }
      if (has_above) {
        whole.append_copy(above);
      }
    }
  }

  /// Appends the argument of a command or a script: a group or a single character.
  void argument_into(pugi::xml_node parent) {
    if (!rest_.empty() && is_digit(rest_.front())) {
      add(parent, "mn", {}, taken(1));
    } else {
      atom_into(parent);
    }
  }

  pugi::xml_node atom_into(pugi::xml_node parent) {
    while (!rest_.empty() && rest_.front() == ' ') {
      rest_.remove_prefix(1);
    }
    if (rest_.empty()) {
      return parent.append_child("mrow");
    }
    const char first = rest_.front();
    if (first == '\\') {
      rest_.remove_prefix(1);
      return command_into(parent);
    }
    if (first == '{') {
      rest_.remove_prefix(1);
      const pugi::xml_node row = parent.append_child("mrow");
      row_into(row);
      rest_.remove_prefix(rest_.empty() ? 0 : 1);
      return row;
    }
    if (is_digit(first)) {
      std::size_t length = 1;
      while (length < rest_.size() && is_digit(rest_[length])) {
        ++length;
      }
      return add(parent, "mn", {}, taken(length));
    }
    if (is_letter(first)) {
      return add(parent, "mi", {}, taken(1));
    }
    const std::string_view sign = taken(1);
    return operator_into(parent, sign == "-" ? "−" : sign);
  }

  pugi::xml_node command_into(pugi::xml_node parent) {
    std::size_t length = 0;
    while (length < rest_.size() && is_letter(rest_[length])) {
      ++length;
    }
    const std::string_view name = taken(length > 0 ? length : std::min<std::size_t>(1, rest_.size()));
    if (name == "frac" || name == "tfrac") {
      pugi::xml_node fraction = parent.append_child("mfrac");
      argument_into(fraction.append_child("mrow"));
      argument_into(fraction.append_child("mrow"));
      return fraction;
    }
    if (name == "hat") {
      const pugi::xml_node hat = add(parent, "mover", {{"accent", "true"}});
      argument_into(hat);
      add(hat, "mo", {}, "^");
      return hat;
    }
    if (name == "text") {
      return add(parent, "mtext", {}, spaced(group()));
    }
    if (name == "mathrm") {
      return add(parent, "mi", {{"mathvariant", "normal"}}, group());
    }
    if (name == "mathbb") {
      const std::string_view letter = group();
      return add(parent, "mi", {}, letter == "R" ? "ℝ" : letter);
    }
    if (name == "left" || name == "right") {
      return atom_into(parent);
    }
    if (name == "," || name == " " || name == "quad") {
      return add(parent, "mspace", {{"width", name == "quad" ? "1em" : (name == "," ? "0.17em" : "0.33em")}});
    }
    if (name == "lVert" || name == "rVert") {
      return operator_into(parent, "‖");
    }
    const auto known = symbols().find(name);
    return known == symbols().end() ? add(parent, "mtext", {}, '\\' + std::string(name))
                                    : add(parent, known->second.element, {}, known->second.text);
  }

  static pugi::xml_node operator_into(pugi::xml_node parent, std::string_view sign) {
    // MathML would set a fence apart from its content.
    const bool is_bar = sign == "|" || sign == "‖";
    return is_bar ? add(parent, "mo", {{"lspace", "0"}, {"rspace", "0"}, {"stretchy", "false"}}, sign)
                  : add(parent, "mo", {}, sign);
  }

  /// The text of {…}.
  std::string_view group() {
    if (rest_.empty() || rest_.front() != '{') {
      return taken(std::min<std::size_t>(1, rest_.size()));
    }
    const std::size_t end = std::min(rest_.find('}'), rest_.size());
    const std::string_view inside = rest_.substr(1, end - 1);
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    return inside;
  }

  /// Non-breaking spaces, because MathML drops spaces at the ends of a text.
  static std::string spaced(std::string_view text) {
    std::string result;
    for (const char letter : text) {
      result += letter == ' ' ? std::string("\xc2\xa0") : std::string(1, letter);
    }
    return result;
  }

  std::string_view taken(std::size_t length) {
    const std::string_view text = rest_.substr(0, length);
    rest_.remove_prefix(length);
    return text;
  }

  std::string_view rest_;
};

}  // namespace

void add_formula(pugi::xml_node parent, std::string_view latex) {
  pugi::xml_node math = add(parent, "math", {{"alttext", latex}});
  LatexReader(latex).row_into(math.append_child("mrow"));
}

}  // namespace carom::report
