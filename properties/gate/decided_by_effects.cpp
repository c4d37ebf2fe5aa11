// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <vector>

#include <fmt/format.h>

#include <carom/properties/cases/draw_within.hpp>
#include <carom/properties/gate/decided_by_effects.hpp>
#include <carom/properties/gate/in_words.hpp>

namespace carom::properties {
namespace {

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

}  // namespace

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

}  // namespace carom::properties
