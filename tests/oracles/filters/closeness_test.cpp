// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include <gtest/gtest.h>

#include <carom/oracles/filters/closeness.hpp>

#include "support/exact.hpp"

namespace carom::oracles {
namespace {

/// Every law that is affine in the outcome and speaks of this collision: visit(name, relation, law).
template <class Visit>
void for_each_affine_law(const ExactCase& exact_case, Model model, const Visit& visit) {
  const Collision& c = exact_case.collision();
  const bool collides = exact_case.approach() == Approach::colliding;
  const bool inert = exact_case.approach() == Approach::inert;
  const auto visit_law = [&](Relation relation, const auto& law) { visit(*law.name(), relation, law); };
  for (const bool a : {true, false}) {
    const bool immovable = a ? c.a.immovable : c.b.immovable;
    if (immovable || !collides) {
      visit_law(Relation::equal, law::Untouched{a});
    }
    if (!immovable) {
      visit_law(Relation::equal, law::AngularMomentum{a});
    }
  }
  if (!c.a.immovable && !c.b.immovable) {
    visit_law(Relation::equal, law::LinearMomentum{});
    visit_law(Relation::equal, law::TotalAngularMomentum{});
  }
  if (collides) {
    visit_law(Relation::equal, law::Restitution{});
  }
  if (inert) {
    return;
  }
  const bool off_a = exact_case.reads_impulse_off_a();
  visit_law(Relation::at_least, law::NonPenetration{});
  visit_law(Relation::at_least, law::Push{off_a});
  if (model == Model::frictionless) {
    visit_law(Relation::equal, law::FrictionlessDirection{off_a});
  } else {
    visit_law(Relation::equal, law::ReflectionPlane{});
  }
}

template <int N>
std::vector<Rational> residual(const Sides<Rational, N>& sides) {
  const auto all = difference(sides.left, sides.right);
  return {all.begin(), all.end()};
}

Outcome<Rational> plus(const Outcome<Rational>& x, const Outcome<Rational>& y, int times) {
  Outcome<Rational> result = x;
  for (std::size_t k = 0; k < 4; ++k) {
    *vectors(result)[k] += *vectors(y)[k] * Rational(times);
  }
  return result;
}

Outcome<Rational> small_outcome(properties::Stream& stream) {
  return {{unit::exact_eighths3(stream, 9), unit::exact_eighths3(stream, 9)},
          {unit::exact_eighths3(stream, 9), unit::exact_eighths3(stream, 9)}};
}

/// What the theorem rests on: g(y + d) + g(y − d) = 2 g(y), and the truth satisfies every law exactly.
TEST(Closeness, RestsOnLawsThatAreAffineAndSatisfiedByTheTruth) {
  properties::Stream stream = properties::stream_from(41);
  for (const auto& [family, one] : unit::valid_cases(4)) {
    const ExactCase exact_case(one.collision);
    for (const Model model : models_with_truth) {
      const Outcome<Rational>& y = exact_case.truth(model).outcome;
      const Outcome<Rational> d = small_outcome(stream);
      for_each_affine_law(exact_case, model, [&, family = family](AffineLaw name, Relation relation, const auto& law) {
        const auto at_truth = residual(law(exact_case.exact(), y));
        const auto above = residual(law(exact_case.exact(), plus(y, d, 1)));
        const auto below = residual(law(exact_case.exact(), plus(y, d, -1)));
        for (std::size_t i = 0; i < at_truth.size(); ++i) {
          EXPECT_EQ(above[i] + below[i], 2 * at_truth[i]) << family << ' ' << static_cast<int>(name);
          EXPECT_TRUE(relation == Relation::equal ? at_truth[i] == 0 : at_truth[i] >= 0)
              << family << ' ' << static_cast<int>(name);
        }
      });
    }
  }
}

/// g(y + d) + g(y − d) ≥ 2 g(y) for E⁺ − W, and it is at most E⁻ at the truth of the frictionless law.
TEST(Closeness, RestsOnAnEnergyThatIsConvex) {
  properties::Stream stream = properties::stream_from(42);
  const auto gain = [](const ExactCase& exact_case, const Outcome<Rational>& y) {
    return residual(energy(exact_case.exact(), y)).front();
  };
  for (const auto& [family, one] : unit::valid_cases(6)) {
    const ExactCase exact_case(one.collision);
    if (exact_case.approach() == Approach::inert) {
      continue;
    }
    const Outcome<Rational>& y = exact_case.truth(Model::frictionless).outcome;
    const Outcome<Rational> d = small_outcome(stream);
    EXPECT_GE(gain(exact_case, plus(y, d, 1)) + gain(exact_case, plus(y, d, -1)), 2 * gain(exact_case, y)) << family;
    EXPECT_LE(gain(exact_case, y), 0) << family;
  }
}

/// ‖∂g/∂ŷ_k‖ of an affine law, exactly: g(y + e) − g(y) for the unit vectors e.
template <class Law>
std::array<double, 4> exact_slopes(const Law& law, const ExactCase& exact_case) {
  const Outcome<Rational> before = unchanged(exact_case.exact());
  const auto at_rest = residual(law(exact_case.exact(), before));
  std::array<double, 4> slopes{};
  for (std::size_t k = 0; k < slopes.size(); ++k) {
    Rational squared(0);
    for (int axis = 0; axis < 3; ++axis) {
      Outcome<Rational> moved = before;
      (*vectors(moved)[k])[axis] += 1;
      const auto there = residual(law(exact_case.exact(), moved));
      for (std::size_t i = 0; i < there.size(); ++i) {
        squared += (there[i] - at_rest[i]) * (there[i] - at_rest[i]);
      }
    }
    slopes[k] = std::sqrt(to_double(squared));
  }
  return slopes;
}

/// Those of the scale are the same to 2⁻⁴⁰, but for r × N, which may cancel.
TEST(Closeness, RestsOnSlopesThatAreKnownToTwelveDigits) {
  for (const auto& [family, one] : unit::valid_cases(6)) {
    const Collision& c = one.collision;
    const ExactCase exact_case(c);
    if (!exact_case.is_moderate()) {
      continue;
    }
    for (const Model model : models_with_truth) {
      for_each_affine_law(exact_case, model, [&, family = family](AffineLaw name, Relation, const auto& law) {
        const std::array<double, 4> computed = slopes_of(law, c);
        const std::array<double, 4> exact = exact_slopes(law, exact_case);
        for (std::size_t k = 0; k < exact.size(); ++k) {
          const bool may_cancel = k % 2 == 1 && (name == AffineLaw::restitution || name == AffineLaw::non_penetration);
          const double arm = lever_arm(k < 2 ? c.a : c.b, c.point).norm();
          EXPECT_NEAR(computed[k], exact[k], may_cancel ? 0x1p-46 * arm * c.normal.norm() : 0x1p-40 * exact[k])
              << family << ' ' << static_cast<int>(name) << ' ' << outcome_vector_names[k];
        }
      });
    }
  }
}

struct Shown {
  int laws = 0;
  int shown = 0;
  int energies = 0;
};

/// The outcome that is the truth rounded to binary64, with each vector moved by up to `times` the allowance of its
/// size: whatever closeness shows of it holds by the exact judge.
Shown expect_shown_to_hold(double times, double least_shown, properties::Stream& stream) {
  Shown counts;
  Yardstick yardstick;
  yardstick.unit_roundoff = unit_roundoff(Precision::binary64);
  Yardstick exactly = yardstick;
  exactly.filtered = false;
  for (const auto& [family, one] : unit::valid_cases(8)) {
    const ExactCase exact_case(one.collision);
    for (const Model model : models_with_truth) {
      ReportedOutcome reported = map_outcome<long double>(exact_case.truth(model).outcome, [](const Rational& x) {
        return static_cast<long double>(nearest_double(x));
      });
      for (Vector3<long double>* part : vectors(reported)) {
        const Vector3<double> step = stream.direction().normalized() * (stream.unit() * times * yardstick.allowance());
        *part += step.cast<long double>() * part->norm();
      }
      const LiftedOutcome outcome(reported);
      const Accuracy measured = accuracy(exact_case, model, outcome, yardstick);
      if (!exact_case.is_moderate() || !outcome.is_moderate() || !measured.is_decided) {
        continue;
      }
      const Closeness closeness(exact_case, outcome, measured, yardstick.allowance());
      for_each_affine_law(exact_case, model, [&, family = family](AffineLaw name, Relation relation, const auto& law) {
        ++counts.laws;
        if (closeness.shows(name)) {
          ++counts.shown;
          const Comparison comparison = compare(law, relation, exact_case, outcome, exactly);
          EXPECT_TRUE(comparison.holds && comparison.is_decided) << family << ' ' << static_cast<int>(name);
        }
      });
      if (model == Model::frictionless && exact_case.approach() != Approach::inert && closeness.shows_energy()) {
        ++counts.energies;
        EXPECT_TRUE(compare(law::Energy{}, Relation::at_most, exact_case, outcome, exactly).holds) << family;
      }
    }
  }
  EXPECT_GE(counts.shown, least_shown * counts.laws) << "of " << counts.laws;
  return counts;
}

TEST(Closeness, ShowsOnlyWhatHolds) {
  properties::Stream stream = properties::stream_from(43);
  EXPECT_GT(expect_shown_to_hold(0, 0.95, stream).energies, 100);
  expect_shown_to_hold(1, 0.8, stream);
  // Within a factor of two of the limit on either side, most laws are not shown.
  const Shown beyond = expect_shown_to_hold(4, 0, stream);
  EXPECT_LT(beyond.shown, beyond.laws / 2);
}

/// Two spheres that only spin, with both lever arms along the normal: r × N = 0, and rounding is all that is left of
/// the scale of N·V⁺.
TEST(Closeness, LeavesANormalVelocityThatCancelsToOthers) {
  Collision c;
  c.normal = {0.1, 0.3, 0.7};
  c.point = {0, 0, 0};
  c.a.position = 3 * c.normal;
  c.b.position = -3 * c.normal;
  c.a.angular_velocity = {1, 2, 3};
  const ExactCase exact_case(c);
  Accuracy close;
  close.error_above = {0, 0x1p-60, 0, 0};
  const LiftedOutcome outcome(map_outcome<long double>(unchanged(c), [](double x) { return x; }));
  const Closeness closeness(exact_case, outcome, close, 0x1p-48);
  EXPECT_TRUE(closeness.shows(AffineLaw::angular_momentum_of_a));
  EXPECT_FALSE(closeness.shows(AffineLaw::non_penetration));
}

TEST(Closeness, ShowsNothingWhereNothingIsKnown) {
  EXPECT_FALSE(Closeness().shows(AffineLaw::push));
  EXPECT_FALSE(Closeness().shows(AffineLaw::non_penetration));
  EXPECT_FALSE(Closeness().shows(AffineLaw::linear_momentum));
  EXPECT_FALSE(Closeness().shows_energy());
  EXPECT_FALSE(Closeness().shows_untouched({0}));
}

}  // namespace
}  // namespace carom::oracles
