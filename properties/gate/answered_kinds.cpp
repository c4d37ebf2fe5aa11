// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <bit>
#include <cstdint>
#include <map>
#include <optional>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <carom/properties/gate/answered_kinds.hpp>

namespace carom::properties {

std::vector<Trait> traits_beside(const Domain& within) {
  std::vector<Trait> traits;
  const auto add = [&](std::string_view name, std::string_view value) {
    const std::string text = fmt::format("{}={}", name, value);
    traits.push_back({name, text, domain_from(text)});
  };
  const std::vector<KindText> limited = texts_of(within.kinds);
  for (const auto& [name, value] : all_kinds()) {
    if (std::ranges::count(limited, name, &KindText::first) == 0) {
      add(name, value);
    }
  }
  const auto add_value = [&](LimitedQuantity coefficient, const char* value) {
    if (within.ranges[coefficient] == whole_range(coefficient)) {
      add(name_of(coefficient), value);
    }
  };
  for (const LimitedQuantity coefficient :
       {LimitedQuantity::restitution, LimitedQuantity::friction, LimitedQuantity::tangential_restitution}) {
    add_value(coefficient, "0");
  }
  add_value(LimitedQuantity::restitution, "1");
  return traits;
}

Domain narrowed(const Domain& domain, const Trait& trait) {
  return domain_from((domain.is_everything() ? "" : to_text(domain) + ",") + trait.text);
}

namespace {

/// A set of traits, as bits.
using Traits = std::uint32_t;

struct Counts {
  std::uint64_t answered = 0;
  std::uint64_t skipped = 0;
};

/// The sampled cases by their traits.
std::map<Traits, Counts> cases_by_traits(const std::vector<Trait>& traits, const SubjectResult& result,
                                         const GateReport& report) {
  std::map<Traits, Counts> cases;
  for (std::size_t f = 0; f < report.sampled.size(); ++f) {
    const std::vector<std::uint64_t>& skipped = result.families[f].skipped_cases;
    for (std::size_t index = 0; index < report.sampled[f].size(); ++index) {
      const SampledCase& one = report.sampled[f][index];
      if (!one.is_valid) {
        continue;
      }
      Traits present = 0;
      for (std::size_t t = 0; t < traits.size(); ++t) {
        present |= contains(traits[t].domain, one.collision) ? Traits{1} << t : 0;
      }
      Counts& counts = cases[present];
      ++(std::ranges::binary_search(skipped, index) ? counts.skipped : counts.answered);
    }
  }
  return cases;
}

Counts counts_with(const std::map<Traits, Counts>& cases, Traits wanted) {
  Counts sum;
  for (const auto& [present, counts] : cases) {
    if ((present & wanted) == wanted) {
      sum.answered += counts.answered;
      sum.skipped += counts.skipped;
    }
  }
  return sum;
}

/// Every set of traits with at most one of each name. Two movable bodies have no wall to rest.
std::vector<Traits> sets_of(const std::vector<Trait>& traits) {
  std::vector<Traits> sets{0};
  for (std::size_t first = 0; first < traits.size();) {
    const std::size_t count = sets.size();
    std::size_t last = first;
    for (; last < traits.size() && traits[last].name == traits[first].name; ++last) {
      for (std::size_t i = 0; i < count; ++i) {
        sets.push_back(sets[i] | Traits{1} << last);
      }
    }
    first = last;
  }
  const auto with = [&](std::string_view text) {
    const auto found = std::ranges::find(traits, text, &Trait::text);
    return found == traits.end() ? Traits{0} : Traits{1} << (found - traits.begin());
  };
  const Traits redundant = with("movable=both") | with("walls=resting");
  std::erase_if(sets, [&](Traits set) { return std::popcount(redundant) == 2 && (set & redundant) == redundant; });
  return sets;
}

/// The traits that separate the answered cases best: the fewest answered cases lack them, and the fewest skipped ones
/// have them. Of several such sets, that with most kinds, because the sample need not have a skipped case that lacks
/// one alone. None if a quarter of the answered cases lack them, or if more than a tenth of the cases that have them
/// are skipped.
std::optional<Traits> common_traits(const std::vector<Trait>& traits, const std::map<Traits, Counts>& cases) {
  const std::uint64_t answered = counts_with(cases, 0).answered;
  const auto badness = [&](Traits set) {
    const Counts inside = counts_with(cases, set);
    return std::pair(answered - inside.answered + inside.skipped, -std::popcount(set));
  };
  const std::vector<Traits> sets = sets_of(traits);
  const Traits best =
      *std::min_element(sets.begin(), sets.end(), [&](Traits x, Traits y) { return badness(x) < badness(y); });
  const Counts inside = counts_with(cases, best);
  const bool separates = 4 * inside.answered >= 3 * answered && 9 * inside.skipped <= inside.answered;
  return separates ? std::optional(best) : std::nullopt;
}

std::string in_words(const Trait& trait) {
  static const std::map<std::string_view, std::string_view> words{
      {"bodies=spheres", "of spheres"},
      {"bodies=solid_spheres", "of solid spheres"},
      {"movable=both", "of two movable bodies"},
      {"movable=one", "of a movable body and a wall"},
      {"movable=a", "of a movable body A and a wall B"},
      {"movable=b", "of a wall A and a movable body B"},
      {"walls=resting", "with walls at rest"},
      {"plane=xy", "in the plane z = 0"},
      {"plane=yz", "in the plane x = 0"},
      {"plane=zx", "in the plane y = 0"},
  };
  const auto found = words.find(trait.text);
  return found == words.end() ? "with " + trait.text : std::string(found->second);
}

}  // namespace

std::string what_it_answers(const SubjectResult& result, const GateReport& report) {
  const Domain& within = report.options.within;
  const std::vector<Trait> traits = traits_beside(within);
  const std::map<Traits, Counts> cases = cases_by_traits(traits, result, report);
  const Counts all = counts_with(cases, 0);
  constexpr std::uint64_t too_few = 10;
  if (all.answered < too_few) {
    return all.answered == 0
               ? "it answered none"
               : fmt::format("it answered {} of {} sampled cases, too few to tell what they have in common",
                             all.answered, all.answered + all.skipped);
  }
  const std::optional<Traits> common = common_traits(traits, cases);
  if (!common) {
    return "no kind separates the answered cases from the skipped ones";
  }
  Domain fitting = within;
  std::vector<std::string> words;
  for (std::size_t t = 0; t < traits.size(); ++t) {
    if ((*common >> t & 1U) != 0) {
      words.push_back(in_words(traits[t]));
      fitting = narrowed(fitting, traits[t]);
    }
  }
  const Counts inside = counts_with(cases, *common);
  const std::string share =
      inside.answered == all.answered ? "only" : fmt::format("mostly ({} of {})", inside.answered, all.answered);
  return fmt::format("it answered {} contacts {}: add --within {}", share, fmt::join(words, ", "), to_text(fitting));
}

}  // namespace carom::properties
