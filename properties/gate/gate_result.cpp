// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include <carom/properties/gate/gate_result.hpp>

namespace carom::properties {

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

Count SubjectResult::count(const std::string& invariant) const {
  Count sum;
  for (const FamilyResult& family : families) {
    const auto found = family.counts.find(invariant);
    if (found != family.counts.end()) {
      sum.holds += found->second.holds;
      sum.violated += found->second.violated;
      sum.skipped += found->second.skipped;
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

bool SubjectResult::is_sound() const {
  const auto holds_anywhere = [](const FamilyResult& family) {
    return std::any_of(family.counts.begin(), family.counts.end(), [](const auto& x) { return x.second.holds > 0; });
  };
  return error.empty() && std::any_of(families.begin(), families.end(), holds_anywhere) &&
         violated_invariants().empty();
}

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
