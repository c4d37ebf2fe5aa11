// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <carom/properties/cases/draw_within.hpp>
#include <carom/properties/gate/answered_kinds.hpp>
#include <carom/properties/gate/gate_report.hpp>
#include <carom/properties/gate/in_words.hpp>

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
  adjusted += other.adjusted;
  return *this;
}

namespace {

template <class T>
T sum_of(const std::vector<FamilyResult>& families, T FamilyResult::*field) {
  T sum{};
  for (const FamilyResult& family : families) {
    sum += family.*field;
  }
  return sum;
}

}  // namespace

std::uint64_t SubjectResult::cases() const { return sum_of(families, &FamilyResult::cases); }
std::uint64_t SubjectResult::skipped() const { return sum_of(families, &FamilyResult::skipped); }
UnjudgedCounts SubjectResult::unjudged() const { return sum_of(families, &FamilyResult::unjudged); }
EffectCounts SubjectResult::decided_by() const { return sum_of(families, &FamilyResult::decided_by); }

EnergyGains SubjectResult::energy(const GateOptions& options) const {
  EnergyGains sum;
  for (std::size_t f = 0; f < families.size(); ++f) {
    EnergyGains of_family = families[f].energy;
    for (std::optional<EnergyGain>* gain : {&of_family.greatest, &of_family.greatest_share}) {
      if (*gain) {
        (*gain)->family = options.families[f];
      }
    }
    sum += of_family;
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
    if (is_claimed && invariant->can_be_judged_in(options.within.kinds) && count(*invariant).judged() == 0) {
      never.push_back(invariant);
    }
  }
  return never;
}

namespace {

/// Why a run cannot judge a subject if `part` of `all` cases say nothing about it.
bool is_more_than_a_tenth(std::uint64_t part, std::uint64_t all) { return part * 10 > all; }

/// Domains in which the effect decides less, the widest first.
std::vector<Domain> narrowed(const Domain& within, DeclaredEffect effect, double size) {
  const auto limited = [&](Domain domain, LimitedQuantity quantity, double most) {
    domain.ranges[quantity].most = std::min(domain.ranges[quantity].most, most);
    return domain;
  };
  if (effect == DeclaredEffect::restitution_threshold || effect == DeclaredEffect::slop) {
    Domain faster = within;
    faster.ranges[LimitedQuantity::approach].least = std::max(faster.ranges[LimitedQuantity::approach].least, size);
    return {faster};
  }
  // A body of the radius ρ spins by up to the speed over ρ. Impulses change speeds by a few times the approach.
  constexpr double usual_size = 0.1;  // m
  constexpr double least_share = 1e-4;
  std::vector<Domain> domains;
  for (double share = 1; share >= least_share; share /= 4) {
    Domain slower = within;
    double speed = size * share;
    if (effect == DeclaredEffect::max_angular_velocity) {
      Range& sizes = slower.ranges[LimitedQuantity::size];
      sizes.least = sizes.least > 0 ? sizes.least : std::min(usual_size, sizes.most);
      slower = limited(slower, LimitedQuantity::spin, 1);
      speed *= sizes.least;
    }
    slower = limited(slower, LimitedQuantity::speed, speed);
    domains.push_back(limited(slower, LimitedQuantity::approach, speed));
  }
  return domains;
}

struct Share {
  std::uint64_t decided = 0;
  std::uint64_t colliding = 0;
};

/// Whether the effect decides the case for a subject that answers by the law.
bool decides(DeclaredEffect effect, const JudgedCase& one, const Subject& subject,
             const oracles::Yardstick& yardstick) {
  if (effect == DeclaredEffect::restitution_threshold || effect == DeclaredEffect::slop) {
    return one.decided_by_approach(yardstick)[effect];
  }
  ExactAnswer answer = lift(reported(one.exact().nearest_truth(subject.law)));
  return take_out_effects(answer, subject.effects, one.exact(), subject.law, yardstick.allowance())[effect];
}

/// Draws a few cases of each family within the domain. The share is empty if there are none.
Share share_within(const Domain& within, DeclaredEffect effect, const Subject& subject, const GateOptions& options) {
  constexpr std::uint64_t cases_of_family = 8;
  const oracles::Yardstick yardstick = oracles::Yardstick::of(subject.precision, options.limits);
  Share share;
  for (const Family* family : options.families) {
    if (!family->is_valid || !has_cases_within(within, *family, options.seed)) {
      continue;
    }
    for (std::uint64_t index = 0; index < cases_of_family; ++index) {
      const JudgedCase one(drawn_case_within(within, *family, options.seed, index), true, subject.effects);
      if (one.is_valid() && one.collides()) {
        ++share.colliding;
        share.decided += decides(effect, one, subject, yardstick) ? 1 : 0;
      }
    }
  }
  return share;
}

bool is_empty(const Domain& domain) {
  return std::ranges::any_of(domain.ranges, [](const Range& range) { return range.least > range.most; });
}

/// No verdict depends on this hint. So a fault of the judge costs the hint alone.
std::string where_it_decides_less(DeclaredEffect effect, const Subject& subject, const GateOptions& options) {
  std::string where = "no domain was found in which it decides less";
  const std::string fault = why_failed([&] {
    for (const Domain& within : narrowed(options.within, effect, subject.effects[effect])) {
      const Share share = is_empty(within) ? Share{} : share_within(within, effect, subject, options);
      if (share.colliding > 0 && !is_more_than_a_tenth(share.decided, share.colliding)) {
        where = fmt::format("it decides {} of {} drawn cases with --within {}", share.decided, share.colliding,
                            to_text(within));
        return;
      }
    }
  });
  return fault.empty() ? where : "no domain was sought, because the judge failed: " + fault;
}

/// The declared effects that decide more than a tenth of the colliding cases. For each, the text names a domain within
/// which the law and the effect leave the subject to be judged. Empty if there is no such effect.
std::string why_decided_by_effects(const SubjectResult& result, const GateOptions& options, std::uint64_t colliding) {
  const EffectCounts decided = result.decided_by();
  std::string text;
  for (const DeclaredEffect effect : all_declared_effects) {
    if (is_more_than_a_tenth(decided[effect], colliding)) {
      DeclaredEffects alone;
      alone[effect] = result.subject.effects[effect];
      text += fmt::format("{}the declared {} decides {} of {} colliding cases, which is more than a tenth; {}",
                          text.empty() ? "" : "; ", to_text(alone), decided[effect], colliding,
                          where_it_decides_less(effect, result.subject, options));
    }
  }
  return text;
}

}  // namespace

namespace {

struct SkippedShare {
  std::uint64_t skipped = 0;
  std::uint64_t all = 0;
};

bool is_of_valid(const Coverage& of_family) { return of_family.invalid < of_family.cases; }

/// Of the valid cases that the subject's precision can hold.
SkippedShare skipped_share(const SubjectResult& result, const std::vector<Coverage>& coverage) {
  SkippedShare share;
  for (std::size_t f = 0; f < result.families.size(); ++f) {
    if (is_of_valid(coverage[f])) {
      share.skipped += result.families[f].skipped;
      share.all += result.families[f].judged() + result.families[f].skipped;
    }
  }
  return share;
}

}  // namespace

bool skips_too_many(const SubjectResult& result, const std::vector<Coverage>& coverage) {
  const SkippedShare share = skipped_share(result, coverage);
  return is_more_than_a_tenth(share.skipped, share.all);
}

std::string why_not_judged(const SubjectResult& result, const GateOptions& options,
                           const std::vector<Coverage>& coverage) {
  if (!result.violated_invariants().empty()) {
    return "";
  }
  for (std::size_t f = 0; f < result.families.size(); ++f) {
    const FamilyResult& family = result.families[f];
    if (family.cases == 0) {
      return "no case of the family " + std::string(options.families[f]->name) + " was judged";
    }
    if (is_of_valid(coverage[f]) && family.skipped > 0 && family.judged() == 0) {
      return "every case of the family " + std::string(options.families[f]->name) + " was skipped";
    }
  }
  if (skips_too_many(result, coverage)) {
    const SkippedShare share = skipped_share(result, coverage);
    return fmt::format("{} of {} cases were skipped, which is more than a tenth", share.skipped, share.all);
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
    result.answers_alone.clear();
    if (!is_cut_short && result.error.empty() && skips_too_many(result, report.coverage)) {
      const std::string answered = what_it_answers(result, report);
      if (result.not_judged.empty()) {
        result.answers_alone = answered;
      } else {
        result.not_judged += "; " + answered;
      }
    }
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
