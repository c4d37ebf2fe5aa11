// SPDX-License-Identifier: BSL-1.0
#include "drawn_defects.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <map>
#include <regex>
#include <utility>

#include <fmt/format.h>

namespace carom::mutants {
namespace {

using properties::diagnosis::Fault;

/// Words that mean the same in a description.
const std::map<std::string, std::vector<std::string>> groups{
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

std::vector<std::string> parts_of(const std::string& text, const char* separator) {
  const std::regex between(separator);
  return {std::sregex_token_iterator(text.begin(), text.end(), between, -1), {}};
}

bool has_part(const std::string& text, const std::string& part) {
  const auto has = [&](const std::string& words) { return text.find(words) != std::string::npos; };
  const auto has_letter = [&] { return std::regex_search(text, std::regex("(^|[^A-Za-z])" + part + "([^A-Za-z]|$)")); };
  if (part.starts_with('!')) {
    return !has_part(text, part.substr(1));
  }
  if (part.starts_with('%')) {
    return std::ranges::any_of(groups.at(part), has);
  }
  if (part == "A" || part == "B") {
    return has_letter() || has("both") || has("bodies");
  }
  if (std::isdigit(static_cast<unsigned char>(part.back())) != 0) {
    return std::regex_search(text, std::regex(part + "(?![0-9]|[.][0-9])"));  // 0 is not 0.5, and 1 is not 1.5
  }
  return part.size() == 1 ? has_letter() : has(part);
}

/// Whether the text has a number within a quarter of the limit. Counts of cases do not count.
bool states(const std::string& text, double limit) {
  static const std::regex counts(R"([0-9]+ of (the )?[0-9]+|[0-9.]+ ?%|[0-9]+ cases)");
  static const std::regex number(R"([0-9]*\.?[0-9]+(e[+-]?[0-9]+)?)");
  const std::string without_counts = std::regex_replace(text, counts, "");
  return std::any_of(std::sregex_iterator(without_counts.begin(), without_counts.end(), number), {},
                     [limit](const std::smatch& at) {
                       constexpr double nearness = 1.25;
                       const double stated = std::strtod(at.str().c_str(), nullptr);
                       return stated >= limit / nearness && stated <= limit * nearness;
                     });
}

double to_three_digits(double x) { return std::strtod(fmt::format("{:.3g}", x).c_str(), nullptr); }

/// All kinds, in the order from which they are drawn.
std::vector<DefectKind> all_kinds() {
  std::vector<DefectKind> kinds(kinds_of_data().begin(), kinds_of_data().end());
  kinds.insert(kinds.end(), kinds_of_steps().begin(), kinds_of_steps().end());
  return kinds;
}

const std::map<Use, std::string> words_of_uses{{in_velocity, " in the relative velocity"},
                                               {in_matrix, " in the collision matrix"},
                                               {in_application, " if the impulse is applied"},
                                               {in_impulse, " if the impulse is computed"},
                                               {everywhere, ""}};

DrawnDefect defect_of(const DefectKind& kind, const Drawn& drawn) {
  const Way& way = kind.ways[drawn.way];
  const bool is_of_both = drawn.at.a && drawn.at.b;
  const char* body = drawn.at.a ? "A" : "B";
  const auto filled = [&](std::string_view text) {
    return fmt::format(fmt::runtime(text), fmt::arg("bodies", is_of_both ? "both bodies" : body),
                       fmt::arg("part", is_of_both ? "A & B" : body), fmt::arg("use", words_of_uses.at(drawn.at.use)),
                       fmt::arg("c", drawn.number), fmt::arg("limit", drawn.number),
                       fmt::arg("how", drawn.number < 0 ? "%sign" : (drawn.number > 0 ? "%times" : "%none")),
                       fmt::arg("axis", "xyz"[drawn.axis]));
  };
  std::string named_by(way.named_by);
  if (way.words.find("{bodies}") != std::string_view::npos && !named_by.empty()) {
    named_by = std::regex_replace(named_by, std::regex(" [|] |$"), " & {part}$&");
  }
  if (const std::string also = way.also_named_by == nullptr ? "" : way.also_named_by(drawn); !also.empty()) {
    named_by += named_by.empty() ? also : " | " + also;
  }
  DrawnDefect defect{kind.by.name, filled(way.words), filled(named_by), {}, {way.change, drawn}};
  if (way.words.find("{limit}") != std::string_view::npos) {
    defect.limit = drawn.number;
  }
  return defect;
}

}  // namespace

double Random::share() { return static_cast<double>(engine_() >> 11U) * 0x1p-53; }

double Random::between(double least, double most) { return to_three_digits(least + (most - least) * share()); }

double Random::log_between(double least, double most) {
  return to_three_digits(least * std::pow(most / least, share()));
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

Place drawn_bodies(Random& random, Use use) {
  return random.one_of<Place>({{true, false, use}, {false, true, use}, {true, true, use}});
}

Place drawn_place(Random& random, std::initializer_list<Use> uses) {
  Place place = drawn_bodies(random);
  place.use = random.one_of(uses);
  return place;
}

DrawnDefect drawn_defect(Law law, Random& random) {
  std::vector<DefectKind> kinds = all_kinds();
  std::erase_if(kinds,
                [law](const DefectKind& kind) { return std::ranges::find(kind.by.laws, law) == kind.by.laws.end(); });
  const DefectKind& kind = kinds[random.below(kinds.size())];
  return defect_of(kind, kind.by.draw(random));
}

std::vector<DrawnDefect> threshold_and_world_axes() {
  constexpr double threshold = 0.5;  // [m/s]
  const std::vector<DefectKind> kinds = all_kinds();
  const auto kind_named = [&](std::string_view name) {
    return *std::ranges::find_if(kinds, [name](const DefectKind& kind) { return kind.by.name == name; });
  };
  return {defect_of(kind_named("restitution_threshold"), {.number = threshold}),
          defect_of(kind_named("orientation_ignored"), {})};
}

bool describes(const Fault& fault, const DrawnDefect& defect) {
  return std::ranges::any_of(parts_of(defect.named_by, " [|] "), [&](const std::string& alternative) {
    return std::ranges::all_of(parts_of(alternative, " & "),
                               [&](const std::string& part) { return has_part(fault.what, part); });
  });
}

bool names(const Fault& fault, const DrawnDefect& defect) {
  return describes(fault, defect) && (!defect.limit || states(fault.what + ' ' + fault.where, *defect.limit));
}

}  // namespace carom::mutants
