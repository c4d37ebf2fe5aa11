// SPDX-License-Identifier: BSL-1.0
#include "detection_report.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include <carom/properties/features/coverage.hpp>

namespace carom::mutants {
namespace {

using properties::all_features;

std::string_view in_words(Sight sight) {
  switch (sight) {
    case Sight::no_case_judged:
      return "no case is judged";
    case Sight::leaves_truth:
      return "truth as it is";
    case Sight::within_rounding:
      return "within rounding";
    case Sight::killed:
      break;
  }
  return "killed";
}

template <class Visit>
void for_each_condition(const Visit& visit) {
  for (std::size_t y = 0; y < all_features().size(); ++y) {
    for (std::size_t x = 0; x <= y; ++x) {
      if (x == y || properties::is_feasible(x, y)) {
        visit(x, y);
      }
    }
  }
}

bool is_explained_by_one(const Detection& detection, Law law, Damage damage, std::size_t x, std::size_t y) {
  const Sight sight = detection.seen(law, damage, x, y).sight;
  return x != y &&
         (detection.seen(law, damage, x, x).sight == sight || detection.seen(law, damage, y, y).sight == sight);
}

std::string condition_of(const Survivor& survivor) {
  const std::string& x = all_features()[survivor.x].name;
  return survivor.x == survivor.y ? x : x + ", " + all_features()[survivor.y].name;
}

/// The kind of a feature, such as "X.speed" or "head_on", without body and decade.
std::string kind_of(const properties::Feature& feature) {
  const std::string& name = feature.kind == properties::FeatureKind::magnitude ? feature.quantity : feature.name;
  const bool of_a_body = name.starts_with("a.") || name.starts_with("b.");
  return of_a_body ? "X." + name.substr(2) : name;
}

/// Prints how many survivors `within_rounding` have features of each kind, the most frequent kinds first.
void print_kinds(std::back_insert_iterator<std::string> out, const Detection& detection) {
  struct Kind {
    std::string names;
    std::uint64_t count = 0;
    float backward_error = 0;
  };
  std::map<std::string, Kind> kinds;
  for (const Survivor& survivor : survivors_of(detection)) {
    if (survivor.seen.sight == Sight::within_rounding) {
      std::pair names{kind_of(all_features()[survivor.x]), kind_of(all_features()[survivor.y])};
      if (names.second < names.first) {
        std::swap(names.first, names.second);
      }
      Kind& kind = kinds["`" + names.first + "`, `" + names.second + "`"];
      ++kind.count;
      kind.backward_error = std::max(kind.backward_error, survivor.seen.backward_error);
    }
  }
  std::vector<Kind> sorted;
  for (auto& [names, kind] : kinds) {
    kind.names = names;
    sorted.push_back(kind);
  }
  std::stable_sort(sorted.begin(), sorted.end(), [](const Kind& x, const Kind& y) { return x.count > y.count; });
  fmt::format_to(out, "\n| pair of features | not killed | largest backward error [ulps] |\n| --- | ---: | ---: |\n");
  constexpr std::size_t most = 12;
  std::uint64_t others = 0;
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    if (i < most) {
      fmt::format_to(out, "| {} | {} | {:.3g} |\n", sorted[i].names, sorted[i].count, sorted[i].backward_error);
    } else {
      others += sorted[i].count;
    }
  }
  fmt::format_to(out, "| {} other kinds | {} | |\n", sorted.size() - std::min(sorted.size(), most), others);
}

void print_score(std::back_insert_iterator<std::string> out, std::string_view format, std::string_view law,
                 std::string_view damage, const Scores& scores) {
  const auto& [singles, pairs] = scores;
  fmt::format_to(out, fmt::runtime(format), law, damage, singles.killed, singles.visible(), singles.percent(),
                 singles.leaves_truth, singles.no_case_judged, pairs.killed, pairs.visible(), pairs.percent(),
                 pairs.leaves_truth, pairs.no_case_judged);
}

}  // namespace

void Score::add(Sight sight) {
  switch (sight) {
    case Sight::no_case_judged:
      ++no_case_judged;
      return;
    case Sight::leaves_truth:
      ++leaves_truth;
      return;
    case Sight::within_rounding:
      ++within_rounding;
      return;
    case Sight::killed:
      ++killed;
      return;
  }
}

Score& Score::operator+=(const Score& other) {
  no_case_judged += other.no_case_judged;
  leaves_truth += other.leaves_truth;
  within_rounding += other.within_rounding;
  killed += other.killed;
  return *this;
}

double Score::percent() const {
  constexpr double all = 100;
  return visible() == 0 ? all : all * static_cast<double>(killed) / static_cast<double>(visible());
}

Scores scores_of(const Detection& detection, Law law, Damage damage) {
  Scores scores;
  for_each_condition([&](std::size_t x, std::size_t y) {
    (x == y ? scores.singles : scores.pairs).add(detection.seen(law, damage, x, y).sight);
  });
  return scores;
}

Scores scores_of(const Detection& detection) {
  Scores sum;
  for (const Law law : detection.laws()) {
    for (const Damage damage : all_damages) {
      const Scores scores = scores_of(detection, law, damage);
      sum.singles += scores.singles;
      sum.pairs += scores.pairs;
    }
  }
  return sum;
}

std::vector<Survivor> survivors_of(const Detection& detection) {
  std::vector<Survivor> survivors;
  for (const Law law : detection.laws()) {
    for (const Damage damage : all_damages) {
      for_each_condition([&](std::size_t x, std::size_t y) {
        const Seen& seen = detection.seen(law, damage, x, y);
        if (seen.sight != Sight::killed && !is_explained_by_one(detection, law, damage, x, y)) {
          survivors.push_back({law, damage, x, y, seen});
        }
      });
    }
  }
  return survivors;
}

std::string to_text(const Detection& detection, bool markdown) {
  std::string text;
  const auto out = std::back_inserter(text);
  if (markdown) {
    fmt::format_to(out,
                   "| law | damage | single features killed | | cannot be seen | pairs killed | | cannot be seen | "
                   "no case judged |\n| --- | --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: |\n");
  } else {
    fmt::format_to(out, "{:<13}{:<28}{:>28}{:>10}{:>10}{:>30}{:>10}{:>10}\n", "law", "damage", "single features killed",
                   "truth", "not judged", "pairs killed", "truth", "not judged");
  }
  const std::string_view row = markdown ? "| {0} | `{1}` | {2} / {3} | {4:.2f} % | {5} | {7} / {8} | {9:.2f} % | {10} "
                                          "| {11} |\n"
                                        : "{0:<13}{1:<28}{2:>10} / {3:>4} {4:>8.2f} %{5:>10}{6:>10}{7:>12} / {8:>6} "
                                          "{9:>7.2f} %{10:>10}{11:>10}\n";
  for (const Law law : detection.laws()) {
    for (const Damage damage : all_damages) {
      print_score(out, row, name_of(law), name_of(damage), scores_of(detection, law, damage));
    }
  }
  print_score(out, row, "all", "all", scores_of(detection));
  fmt::format_to(out, "\n{} colliding cases, {} of them judged in binary64, {} sound outcomes rejected\n",
                 detection.cases(), detection.judged(), detection.sound_rejected());
  if (markdown) {
    print_kinds(out, detection);
    return text;
  }
  fmt::format_to(out, "\nnot killed (pairs: where neither feature alone is the reason)\n");
  for (const Survivor& survivor : survivors_of(detection)) {
    fmt::format_to(out, "{:<13}{:<28}{:<16}{:<70}", name_of(survivor.law), name_of(survivor.damage),
                   in_words(survivor.seen.sight), condition_of(survivor));
    if (survivor.seen.sight == Sight::within_rounding) {
      fmt::format_to(out, "{:>8} cases, at most {:.3g} ulps", survivor.seen.changed, survivor.seen.backward_error);
    }
    fmt::format_to(out, "\n");
  }
  return text;
}

}  // namespace carom::mutants
