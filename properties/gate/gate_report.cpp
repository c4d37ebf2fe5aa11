// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <carom/properties/gate/gate_report.hpp>

namespace carom::properties {

namespace {

/// Invariants that apply to the outcomes of colliding contacts.
constexpr std::array exercised_by_collisions{"backward_error", "linear_momentum", "angular_momentum",
                                             "restitution",    "non_penetration", "push"};

}  // namespace

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

Count SubjectResult::count(const std::string& invariant) const {
  Count sum;
  for (const FamilyResult& family : families) {
    const auto found = family.counts.find(invariant);
    if (found != family.counts.end()) {
      sum += found->second;
    }
  }
  return sum;
}

std::vector<std::string> SubjectResult::violated_invariants() const {
  std::vector<std::string> names;
  for (const Invariant& invariant : all_invariants()) {
    if (count(std::string(invariant.name)).violated > 0) {
      names.emplace_back(invariant.name);
    }
  }
  return names;
}

std::string why_not_judged(const SubjectResult& result, const std::vector<const Family*>& families,
                           const std::vector<Coverage>& coverage) {
  std::uint64_t valid = 0;
  std::uint64_t skipped_of_valid = 0;
  for (std::size_t f = 0; f < result.families.size(); ++f) {
    const FamilyResult& family = result.families[f];
    if (family.cases == 0) {
      return "no case of the family " + std::string(families[f]->name) + " was judged";
    }
    const bool is_of_valid = coverage[f].invalid < coverage[f].cases;
    if (is_of_valid && family.skipped > 0 && family.judged() == 0) {
      return "every case of the family " + std::string(families[f]->name) + " was skipped";
    }
    valid += is_of_valid ? family.judged() + family.skipped : 0;
    skipped_of_valid += is_of_valid ? family.skipped : 0;
  }
  constexpr std::uint64_t one_in = 10;  // at most this share of the cases may be skipped, or lie at a limit
  if (skipped_of_valid * one_in > valid) {
    return std::to_string(skipped_of_valid) + " of " + std::to_string(valid) +
           " cases were skipped, which is more than a tenth";
  }
  const std::uint64_t at_limit = result.unjudged()[Unjudged::at_declared_limit];
  if (at_limit * one_in > result.cases()) {
    return std::to_string(at_limit) + " of " + std::to_string(result.cases()) +
           " cases lie at a declared threshold or slop, which is more than a tenth";
  }
  // Every law claims at least one of `exercised_by_collisions`.
  const auto is_exercised = [&](const char* invariant) { return result.count(invariant).holds > 0; };
  const bool was_answered = std::any_of(exercised_by_collisions.begin(), exercised_by_collisions.end(), is_exercised);
  const bool is_of_collisions =
      std::any_of(coverage.begin(), coverage.end(), [](const Coverage& of_family) { return of_family.colliding > 0; });
  if (is_of_collisions && !was_answered) {
    return "no case exercised an invariant of the outcome of a colliding contact";
  }
  const auto holds_anywhere = [](const FamilyResult& family) {
    return std::any_of(family.counts.begin(), family.counts.end(), [](const auto& x) { return x.second.holds > 0; });
  };
  return std::any_of(result.families.begin(), result.families.end(), holds_anywhere) ? ""
                                                                                     : "no case exercised an invariant";
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
      worst = {families[f].worst_backward_error, std::string(options.families[f]->name)};
    }
  }
  return worst;
}

}  // namespace carom::properties
