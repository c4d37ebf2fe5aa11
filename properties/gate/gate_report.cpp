// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <carom/properties/gate/decided_by_effects.hpp>

namespace carom::properties {

std::uint64_t cases_of(const GateOptions& options, const Family& family) {
  if (options.budget) {
    return std::numeric_limits<std::uint64_t>::max();
  }
  const std::uint64_t all = options.cases * static_cast<std::uint64_t>(family.weight);
  return (all + options.shard.of - options.shard.number) / options.shard.of;
}

Coverage& Coverage::operator+=(const Coverage& other) {
  cases += other.cases;
  colliding += other.colliding;
  resting += other.resting;
  separating += other.separating;
  inert += other.inert;
  invalid += other.invalid;
  one_immovable += other.one_immovable;
  spheres += other.spheres;
  head_on += other.head_on;
  inelastic += other.inelastic;
  elastic += other.elastic;
  for (const Adjustment adjustment : all_adjustments) {
    adjusted[adjustment] += other.adjusted[adjustment];
  }
  return *this;
}

std::uint64_t SubjectResult::cases() const {
  std::uint64_t sum = 0;
  for (const FamilyResult& family : families) {
    sum += family.cases;
  }
  return sum;
}

std::uint64_t SubjectResult::skipped() const {
  std::uint64_t sum = 0;
  for (const FamilyResult& family : families) {
    sum += family.skipped;
  }
  return sum;
}

UnjudgedCounts SubjectResult::unjudged() const {
  UnjudgedCounts sum{};
  for (const FamilyResult& family : families) {
    for (const Unjudged reason : all_reasons_unjudged) {
      sum[reason] += family.unjudged[reason];
    }
  }
  return sum;
}

EffectCounts SubjectResult::decided_by() const {
  EffectCounts sum{};
  for (const FamilyResult& family : families) {
    for (const DeclaredEffect effect : all_declared_effects) {
      sum[effect] += family.decided_by[effect];
    }
  }
  return sum;
}

Count SubjectResult::count(const Invariant& invariant) const {
  Count sum;
  for (const FamilyResult& family : families) {
    const auto found = family.counts.find(&invariant);
    if (found != family.counts.end()) {
      sum += found->second;
    }
  }
  return sum;
}

std::vector<const Invariant*> SubjectResult::violated_invariants() const {
  std::vector<const Invariant*> violated;
  for (const Invariant& invariant : all_invariants()) {
    if (count(invariant).violated > 0) {
      violated.push_back(&invariant);
    }
  }
  return violated;
}

std::vector<const Invariant*> SubjectResult::never_judged(const GateOptions& options) const {
  std::vector<const Invariant*> never;
  const Claim claim = claim_of(subject, options.limits);
  for (const Invariant* invariant : claim.invariants) {
    const bool is_claimed = std::ranges::any_of(
        options.families, [&](const Family* family) { return claim.is_made_in(*invariant, *family); });
    if (is_claimed && count(*invariant).judged() == 0) {
      never.push_back(invariant);
    }
  }
  return never;
}

std::string why_not_judged(const SubjectResult& result, const GateOptions& options,
                           const std::vector<Coverage>& coverage) {
  if (!result.violated_invariants().empty()) {
    return "";
  }
  std::uint64_t valid = 0;
  std::uint64_t skipped_of_valid = 0;
  for (std::size_t f = 0; f < result.families.size(); ++f) {
    const FamilyResult& family = result.families[f];
    if (family.cases == 0) {
      return "no case of the family " + std::string(options.families[f]->name) + " was judged";
    }
    const bool is_of_valid = coverage[f].invalid < coverage[f].cases;
    if (is_of_valid && family.skipped > 0 && family.judged() == 0) {
      return "every case of the family " + std::string(options.families[f]->name) + " was skipped";
    }
    valid += is_of_valid ? family.judged() + family.skipped : 0;
    skipped_of_valid += is_of_valid ? family.skipped : 0;
  }
  if (is_more_than_a_tenth(skipped_of_valid, valid)) {
    return std::to_string(skipped_of_valid) + " of " + std::to_string(valid) +
           " cases were skipped, which is more than a tenth";
  }
  std::uint64_t colliding = 0;
  for (const Coverage& of_family : coverage) {
    colliding += of_family.colliding;
  }
  if (std::string decided = why_decided_by_effects(result, options, colliding); !decided.empty()) {
    return decided;
  }
  // Every law claims at least one invariant of the outcomes of colliding contacts.
  const bool was_answered = std::ranges::any_of(all_invariants(), [&](const Invariant& invariant) {
    const auto* const about = std::get_if<AboutOutcome>(&invariant.about);
    return about != nullptr && about->is_of_colliding && result.count(invariant).holds > 0;
  });
  if (colliding > 0 && !was_answered) {
    return "no case exercised an invariant of the outcome of a colliding contact";
  }
  const auto holds_anywhere = [](const FamilyResult& family) {
    return std::any_of(family.counts.begin(), family.counts.end(), [](const auto& x) { return x.second.holds > 0; });
  };
  if (std::none_of(result.families.begin(), result.families.end(), holds_anywhere)) {
    return "no case exercised an invariant";
  }
  const std::vector<std::string> never = names_of(result.never_judged(options));
  return options.is_part || options.shard.of > 1 || never.empty()
             ? ""
             : fmt::format(
                   "no case judged {}. Choose other families, more cases or a wider domain, or leave "
                   "them out: --deviates {}",
                   fmt::join(never, ", "), fmt::join(never, ","));
}

void state_what_was_not_judged(GateReport& report) {
  for (SubjectResult& result : report.results) {
    const bool is_cut_short = report.judge_error && result.violated_invariants().empty();
    result.not_judged =
        is_cut_short ? "the judge failed, and ended the run" : why_not_judged(result, report.options, report.coverage);
  }
}

bool SubjectResult::is_sound() const { return error.empty() && not_judged.empty() && violated_invariants().empty(); }

std::optional<double> SubjectResult::digits_at_least(double share) const {
  if (digits.size() == 0) {
    return std::nullopt;
  }
  const auto count = static_cast<double>(digits.size());
  const auto above = static_cast<std::uint64_t>(std::ceil(share * count));
  return digits.at(digits.size() - std::clamp<std::uint64_t>(above, 1, digits.size()));
}

SubjectResult::WorstFamily SubjectResult::worst_backward_error(const GateOptions& options) const {
  WorstFamily worst;
  for (std::size_t f = 0; f < families.size(); ++f) {
    if (families[f].worst_backward_error > worst.backward_error) {
      worst = {families[f].worst_backward_error, options.families[f]};
    }
  }
  return worst;
}

}  // namespace carom::properties
