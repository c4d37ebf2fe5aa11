// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <set>
#include <vector>

#include <fmt/format.h>

#include <carom/properties/draws/relative_velocity.hpp>
#include <carom/properties/draws/vectors.hpp>
#include <carom/properties/gate/suggested_effects.hpp>

namespace carom::properties {
namespace {

using oracles::ContactState;
using V = Vector3<double>;

/// Fewer cases suggest nothing.
constexpr std::ptrdiff_t least_cases = 10;
/// ε and ε N·V⁻ below this share are not told from zero.
constexpr double visible = 0x1p-7;
/// Answers that differ by less have one value, also in binary32.
constexpr double sameness = 0x1p-17;

/// The number of fewest digits in the interval. Precondition: 0 < least ≤ most.
double roundest_in(double least, double most) {
  constexpr int all_digits = 17;
  for (int digits = 1; digits < all_digits; ++digits) {
    const double unit = std::pow(10.0, std::floor(std::log10(most)) - digits + 1);
    const double round = std::strtod(fmt::format("{:.{}g}", std::floor(most / unit) * unit, digits).c_str(), nullptr);
    if (least <= round && round <= most) {
      return round;
    }
  }
  return most;
}

double approach_of(const Collision& c) { return -dot(c.normal, relative_velocity(c)) / length(c.normal); }

struct Wrong {
  const SampledCase& sampled;
  const Outcome<double>& answer;
};

/// The sampled violated answers, and the speeds of approach of the sampled colliding cases without a violation.
class Sample {
 public:
  Sample(const SubjectResult& result, const GateReport& report) {
    for (std::size_t f = 0; f < report.sampled.size(); ++f) {
      const FamilyResult& family = result.families[f];
      std::set<std::uint64_t> excluded(family.skipped_cases.begin(), family.skipped_cases.end());
      for (const auto& [invariant, cases] : family.violated_cases) {
        // A relation may fail because of the answer to a slower collision.
        if (invariant->is_of_one_answer()) {
          excluded.insert(cases.begin(), cases.end());
        }
      }
      const std::vector<SampledCase>& cases = report.sampled[f];
      for (const SampledAnswer& answer : family.sampled_answers) {
        if (answer.kind == AnswerKind::outcome && cases[answer.index].is_valid) {
          wrong_.push_back({cases[answer.index], answer.outcome});
        }
      }
      for (std::size_t index = 0; index < cases.size(); ++index) {
        const SampledCase& one = cases[index];
        if (one.is_valid && one.approach == ContactState::colliding && one.collision.restitution > visible &&
            !excluded.contains(index)) {
          right_.push_back(approach_of(one.collision));
        }
      }
    }
    std::ranges::sort(right_);
  }

  [[nodiscard]] const std::vector<Wrong>& wrong() const { return wrong_; }

  /// A limit of the speed of approach, below which colliding cases are answered as `is_so` says. 0 if there is none.
  /// At some slower cases, rounding may hide the effect.
  template <class IsSo>
  [[nodiscard]] double limit_of_approach(const IsSo& is_so) const {
    double fastest = 0;
    std::ptrdiff_t count = 0;
    for (const Wrong& one : wrong_) {
      if (one.sampled.approach == ContactState::colliding && is_so(one)) {
        fastest = std::max(fastest, approach_of(one.sampled.collision));
        ++count;
      }
    }
    const auto faster = std::upper_bound(right_.begin(), right_.end(), fastest);
    if (count < least_cases || 2 * (faster - right_.begin()) >= count || faster == right_.end()) {
      return 0;
    }
    // A case that is not judged is no right case, so the limit may be a little larger.
    constexpr double unsharp = 1.01;
    return roundest_in(std::nextafter(fastest, *faster), std::max(*faster, unsharp * fastest));
  }

 private:
  std::vector<Wrong> wrong_;
  std::vector<double> right_;  // speeds of approach, ascending
};

bool stops(const Wrong& one) {
  const Collision& c = one.sampled.collision;
  const double approach = dot(c.normal, relative_velocity(c));
  const double parting = dot(c.normal, relative_velocity(with_velocities(c, one.answer)));
  return c.restitution > visible && std::abs(parting) <= visible * c.restitution * std::abs(approach);
}

bool is_unchanged(const Wrong& one) {
  const Outcome<double> before = unchanged(one.sampled.collision);
  return std::ranges::all_of(all_outcome_vectors,
                             [&](OutcomeVector k) { return *vectors(one.answer)[k] == *vectors(before)[k]; });
}

/// Calls use(before, after) for the velocity or the spin of each movable body.
template <class Use>
void for_each_movable(const Wrong& one, bool is_spin, const Use& use) {
  const Collision& c = one.sampled.collision;
  const auto of_body = [&](const Body& body, const BodyVelocity<double>& after) {
    if (!body.immovable) {
      use(is_spin ? body.angular_velocity : body.velocity, is_spin ? after.angular_velocity : after.velocity);
    }
  };
  of_body(c.a, one.answer.a);
  of_body(c.b, one.answer.b);
}

/// The fraction that contacts lose which do not collide; 0 if fewer than nine in ten agree.
double damping(const Sample& sample, bool is_spin, double roundoff) {
  std::vector<double> lost;
  for (const Wrong& one : sample.wrong()) {
    if (one.sampled.approach == ContactState::colliding) {
      continue;
    }
    for_each_movable(one, is_spin, [&](const V& before, const V& after) {
      const double squared = dot(before, before);
      if (std::isnormal(squared)) {
        const double kept = dot(after, before) / squared;
        const bool is_along = length(V(after - kept * before)) <= sameness * length(before);
        lost.push_back(is_along ? 1 - kept : 0);
      }
    });
  }
  const auto all = static_cast<std::ptrdiff_t>(lost.size());
  if (all < least_cases) {
    return 0;
  }
  std::ranges::sort(lost);
  const double median = lost[lost.size() / 2];
  const double spread = sameness * std::abs(median) + 8 * roundoff;
  const auto first = std::lower_bound(lost.begin(), lost.end(), median - spread);
  const auto last = std::upper_bound(lost.begin(), lost.end(), median + spread);
  return median > spread && 10 * (last - first) >= 9 * all ? roundest_in(median - spread, median + spread) : 0;
}

/// The greatest length of an answer, if many answers have it; 0 otherwise.
double limit_of_length(const Sample& sample, bool is_spin, double roundoff) {
  std::vector<double> lengths;
  for (const Wrong& one : sample.wrong()) {
    for_each_movable(one, is_spin, [&](const V& /*before*/, const V& after) { lengths.push_back(length(after)); });
  }
  if (lengths.empty()) {
    return 0;
  }
  const double most = *std::max_element(lengths.begin(), lengths.end());
  const double least = most * (1 - sameness);
  const auto have_it = std::ranges::count_if(lengths, [&](double x) { return x >= least; });
  return std::isfinite(most) && most > 0 && have_it >= least_cases
             ? roundest_in(most * (1 - 16 * roundoff), most * (1 + 16 * roundoff))
             : 0;
}

}  // namespace

DeclaredEffects suggested_effects(const SubjectResult& result, const GateReport& report) {
  const Sample sample(result, report);
  const Subject& subject = result.subject;
  const double roundoff = unit_roundoff(subject.precision);
  DeclaredEffects suggested;
  const auto suggest = [&](DeclaredEffect effect, double size) {
    suggested[effect] = subject.effects[effect] == 0 && is_valid_size(effect, size) ? size : 0;
  };
  suggest(DeclaredEffect::restitution_threshold, sample.limit_of_approach(stops));
  suggest(DeclaredEffect::slop, sample.limit_of_approach(is_unchanged));
  suggest(DeclaredEffect::linear_damping, damping(sample, false, roundoff));
  suggest(DeclaredEffect::angular_damping, damping(sample, true, roundoff));
  if (determines_outcome(subject.law)) {
    suggest(DeclaredEffect::max_speed, limit_of_length(sample, false, roundoff));
    suggest(DeclaredEffect::max_angular_velocity, limit_of_length(sample, true, roundoff));
  }
  return suggested;
}

}  // namespace carom::properties
