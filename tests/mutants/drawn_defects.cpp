// SPDX-License-Identifier: BSL-1.0
#include "drawn_defects.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <ranges>
#include <regex>
#include <stdexcept>

#include <fmt/format.h>

namespace carom::mutants {
namespace {

/// Words that mean the same in a description.
struct Group {
  std::string_view name;
  std::vector<std::string_view> words;
};

const Group groups[]{
    {"%sign",
     {"wrong sign", "other sign", "opposite", "reversed", "negative", "negated", "inverted", "wrong direction",
      "other direction", "same direction", "wrong way", "the other way"}},
    {"%times", {"multiplied by", "doubled", "halved", "a factor", "scaled", "too large by", "too small by", "twice"}},
    {"%swapped", {"swapped", "exchanged", "permuted", "interchanged", "other body", "each other's"}},
    {"%none",
     {"zero", "left out", "ignored", "without", "neither", "missing", "were 0", "could not", "got no", "had no",
      "no spin", "no reaction", "no impulse", "not changed"}},
    {"%limit", {"limited", "at most", "capped", "clamped", "a limit", "no more than"}},
    {"%float", {"binary32", "float", "single precision"}},
};

std::string trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(' ');
  return first == std::string_view::npos ? "" : std::string(text.substr(first, text.find_last_not_of(' ') - first + 1));
}

std::vector<std::string> parts_of(std::string_view text, char separator) {
  std::vector<std::string> parts;
  for (std::size_t from = 0; from <= text.size();) {
    const std::size_t to = std::min(text.find(separator, from), text.size());
    parts.push_back(trimmed(text.substr(from, to - from)));
    from = to + 1;
  }
  return parts;
}

bool has_word(const std::string& text, const std::string& word) {
  const auto is_letter = [&](std::size_t i) {
    return i < text.size() && std::isalpha(static_cast<unsigned char>(text[i])) != 0;
  };
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) {
    if ((at == 0 || !is_letter(at - 1)) && !is_letter(at + word.size())) {
      return true;
    }
  }
  return false;
}

bool has_part(const std::string& text, const std::string& part) {
  if (part.starts_with('!')) {
    return !has_part(text, part.substr(1));
  }
  if (part == "A" || part == "B") {
    return has_word(text, part) || text.find("both") != std::string::npos || text.find("bodies") != std::string::npos;
  }
  if (part.starts_with('%')) {
    const auto* group = std::ranges::find(groups, std::string_view(part), &Group::name);
    if (group == std::end(groups)) {
      throw std::logic_error("no group " + part);
    }
    return std::ranges::any_of(group->words,
                               [&](std::string_view word) { return text.find(word) != std::string::npos; });
  }
  return part.size() == 1 ? has_word(text, part) : text.find(part) != std::string::npos;
}

/// Whether the text has a number within a quarter of the limit. Counts of cases do not count.
bool states(const std::string& text, double limit) {
  static const std::regex counts(R"([0-9]+ of (the )?[0-9]+|[0-9.]+ ?%|[0-9]+ cases)");
  static const std::regex number(R"([0-9]*\.?[0-9]+(e[+-]?[0-9]+)?)");
  constexpr double nearness = 1.25;
  const std::string without_counts = std::regex_replace(text, counts, "");
  for (std::sregex_iterator at(without_counts.begin(), without_counts.end(), number); at != std::sregex_iterator();
       ++at) {
    const double stated = std::strtod(at->str().c_str(), nullptr);
    if (stated >= limit / nearness && stated <= limit * nearness) {
      return true;
    }
  }
  return false;
}

double to_three_digits(double x) { return std::strtod(fmt::format("{:.3g}", x).c_str(), nullptr); }

}  // namespace

double Random::between(double least, double most) {
  constexpr double unit = 0x1p-53;
  return to_three_digits(least + (most - least) * static_cast<double>(engine_() >> 11U) * unit);
}

double Random::log_between(double least, double most) {
  constexpr double unit = 0x1p-53;
  return to_three_digits(least * std::pow(most / least, static_cast<double>(engine_() >> 11U) * unit));
}

double Random::factor() {
  constexpr double most = 5;
  constexpr double least_difference = 0.15;
  double drawn = 1;
  while (std::abs(drawn - 1) < least_difference) {
    drawn = log_between(1 / most, most);
  }
  return drawn;
}

std::vector<DefectKind> all_defect_kinds() {
  std::vector<DefectKind> kinds(kinds_of_data().begin(), kinds_of_data().end());
  kinds.insert(kinds.end(), kinds_of_steps().begin(), kinds_of_steps().end());
  return kinds;
}

DrawnDefect drawn_defect(const DefectKind& kind, Random& random) {
  DrawnDefect defect = kind.draw(random);
  defect.kind = kind.name;
  return defect;
}

std::vector<DrawnDefect> threshold_and_world_axes() {
  constexpr double threshold = 0.5;  // [m/s]
  std::vector<DrawnDefect> defects{restitution_threshold_at(threshold),
                                   orientation_ignored_in({true, true, "both bodies", "A & B"}, everywhere)};
  defects[0].kind = "restitution_threshold";
  defects[1].kind = "orientation_ignored";
  return defects;
}

bool describes(const properties::diagnosis::Fault& fault, const DrawnDefect& defect) {
  const auto is_said = [&](const std::string& alternative) {
    return std::ranges::all_of(parts_of(alternative, '&'),
                               [&](const std::string& part) { return has_part(fault.what, part); });
  };
  return std::ranges::any_of(parts_of(defect.named_by, '|'), is_said);
}

bool names(const properties::diagnosis::Fault& fault, const DrawnDefect& defect) {
  return describes(fault, defect) && (!defect.limit || states(fault.what + ' ' + fault.where, *defect.limit));
}

Which drawn_bodies(Random& random) {
  return random.one_of<Which>({{true, false, "A", "A"}, {false, true, "B", "B"}, {true, true, "both bodies", "A & B"}});
}

void change_data(DrawnDefect& defect, const Which& which, unsigned uses,
                 std::function<void(impulse::ContactBody<double>&, const Body&)> change) {
  defect.change.uses = uses;
  defect.change.data = [which, change = std::move(change)](impulse::Contact<double>& contact, const Collision& read) {
    if (which.a) {
      change(contact.a, read.a);
    }
    if (which.b) {
      change(contact.b, read.b);
    }
  };
  switch (uses) {
    case in_velocity:
      defect.words += " in the relative velocity";
      break;
    case in_matrix:
      defect.words += " in the collision matrix";
      break;
    case in_application:
      defect.words += " if the impulse is applied";
      break;
    case in_impulse:
      defect.words += " if the impulse is computed";
      break;
    default:
      break;
  }
}

Vector3<double> across(const Vector3<double>& normal, const Vector3<double>& v) {
  return v - normal * (normal.dot(v) / normal.squaredNorm());
}

}  // namespace carom::mutants
