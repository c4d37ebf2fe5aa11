// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>
#include <limits>

#include <carom/oracles/bounds/slopes.hpp>
#include <carom/oracles/judge/compare.hpp>

#include "covers.hpp"
#include "moderate_collisions.hpp"

/// Checks the constants of oracles/bounds/moderate.hpp by the inequalities (1) to (5) of is_moderate, on collisions at
/// the limits (moderate_collisions.hpp).
namespace carom::bounds {
namespace {

using oracles::MagnitudeDual;

template <class Visit>
void for_each_law(const Collision& c, const Visit& visit) {
  namespace equation = oracles::equation;
  for (const bool a : {true, false}) {
    visit(equation::Untouched{a ? OutcomeVector::velocity_of_a : OutcomeVector::velocity_of_b});
    visit(equation::Untouched{a ? OutcomeVector::angular_velocity_of_a : OutcomeVector::angular_velocity_of_b});
    if (!(a ? c.a.immovable : c.b.immovable)) {
      visit(equation::AngularMomentum{a});
      visit(equation::Push{a});
      visit(equation::FrictionlessDirection{a});
    }
  }
  if (!c.a.immovable && !c.b.immovable) {
    visit(equation::LinearMomentum{});
    visit(equation::TotalAngularMomentum{});
  }
  visit(equation::Restitution{});
  visit(equation::NonPenetration{});
  visit(equation::ReflectionPlane{});
  visit(equation::Sticks{});
  visit(equation::Energy{});
}

/// The equations of friction are quadratic in the outcome.
template <class Visit>
void for_each_law_of_friction(const Collision& c, const Visit& visit) {
  namespace equation = oracles::equation;
  for (const bool a : {true, false}) {
    if (!(a ? c.a.immovable : c.b.immovable)) {
      visit(equation::FrictionCone{a});
      visit(equation::FrictionAlongSlip{a});
      visit(equation::FrictionAgainstSlip{a});
    }
  }
}

TEST(ModerateBounds, AreOfCollisionsThatAreModerate) {
  for (const Corner& corner : corners()) {
    const Collision c = collision_at(corner);
    EXPECT_TRUE(oracles::is_moderate(c));
    Collision further = c;
    further.b.position[1] *= 1.5;
    EXPECT_FALSE(oracles::is_moderate(further));
    further = c;
    further.normal[2] *= corner.normal > 1 ? 1.5 : 1 / 1.5;
    EXPECT_FALSE(oracles::is_moderate(further));
  }
}

struct Largest {
  double scale = -std::numeric_limits<double>::infinity();
  double on_the_way = scale;

  void note_way() { on_the_way = std::max(on_the_way, Magnitude::highest()); }
};

template <class Equation>
Magnitude scale_at(const Equation& equation, const Collision& c) {
  const auto length_of = [](const Magnitude& size) { return sqrt(size * size + size * size + size * size); };
  const Magnitude after = length_of(Magnitude(oracles::largest_moderate_outcome));
  const Magnitude before = length_of(Magnitude(oracles::largest_moderate));
  Magnitude scale = oracles::part_by_inputs(equation, differentiated(c), largest_outcome());
  for (const Magnitude& slope :
       oracles::output_slopes<Magnitude, oracles::outcome_inputs>(equation, c, largest_outcome())) {
    scale += slope * (after + before);
  }
  return scale;
}

/// Inequalities (2) and (4).
TEST(ModerateBounds, CoverTheScaleOfEveryLaw) {
  Largest largest;
  for (const Corner& corner : corners()) {
    const Collision c = collision_at(corner);
    for_each_law(c, [&](const auto& equation) {
      Magnitude::forget();
      const Magnitude scale = scale_at(equation, c);
      largest.note_way();
      largest.scale = std::max(largest.scale, scale.above());
    });
  }
  EXPECT_TRUE(is_least_that_covers(oracles::largest_scale_of_moderate, largest.scale));
  EXPECT_LE(largest.on_the_way, std::log2(oracles::largest_on_the_way_of_moderate));
}

/// Inequalities (2) and (4) for friction. The judge accepts the scale, and the equation does not overflow. Squares in
/// the computation of the scale may overflow, because the judge then uses extended precision.
TEST(ModerateBounds, CoverTheScaleOfFriction) {
  Largest largest;
  for (const Corner& corner : corners()) {
    const Collision c = collision_at(corner);
    for_each_law_of_friction(c, [&](const auto& equation) {
      largest.scale = std::max(largest.scale, scale_at(equation, c).above());
      Magnitude::forget();
      const auto sides = equation(map_numbers<Magnitude>(c, [](double x) { return Magnitude(x); }),
                                  map_outcome<Magnitude>(largest_outcome(), [](double x) { return Magnitude(x); }));
      largest.note_way();
      largest.on_the_way = std::max(largest.on_the_way, sides.left[0].above());
    });
  }
  EXPECT_TRUE(is_least_that_covers(oracles::largest_scale_of_moderate_friction, largest.scale));
  EXPECT_LE(oracles::largest_scale_of_moderate_friction, oracles::largest_scale);
  EXPECT_LE(largest.on_the_way, std::log2(oracles::largest_on_the_way_of_moderate));
}

Magnitude sensitivity(const std::vector<const MagnitudeDual*>& y, const std::vector<oracles::Quantity>& quantities) {
  return oracles::sum_over_quantities(quantities, y.size(),
                                      [&](std::size_t i, std::size_t j) { return y[i]->derivative[j]; });
}

/// Inequalities (1), (3) and (4) for the linear laws. (exact_case_bounds.hpp covers `rough`.) Masses and moments
/// occur only in denominators, so the smallest give the largest results.
TEST(ModerateBounds, CoverTheSensitivityOfTheTruth) {
  Largest largest;
  const double log_of_lambda = -std::log2(oracles::largest_moderate_mass);
  for (const Corner& corner : corners()) {
    if (!corner.is_light) {
      continue;
    }
    const auto inputs = differentiated(collision_at(corner));
    for (const Law law : oracles::linear_laws) {
      Magnitude::forget();
      // By (1), N·K N ≥ N·N / M, and N·N is at least corner.normal².
      const Magnitude::DivisorsAtLeast theorem(2 * std::log2(corner.normal) + log_of_lambda);
      const oracles::Truth<MagnitudeDual> truth =
          oracles::colliding_truth(inputs.collision, law, oracles::Branch::only);
      const Matrix3<MagnitudeDual> k = oracles::response_matrix(inputs.collision);
      largest.note_way();
      const Outcome<MagnitudeDual> at_rest = unchanged(inputs.collision);
      for (const OutcomeVector part : all_outcome_vectors) {
        const Vector3<MagnitudeDual>& y = *vectors(truth.outcome)[part];
        const Vector3<MagnitudeDual>& before = *vectors(at_rest)[part];
        const Magnitude of_vector = sensitivity({&y[0], &y[1], &y[2]}, inputs.quantities) +
                                    length({before[0].value, before[1].value, before[2].value});
        largest.scale = std::max(largest.scale, of_vector.above());
      }
      const Magnitude of_matrix =
          sensitivity({&k(0, 0), &k(0, 1), &k(0, 2), &k(1, 0), &k(1, 1), &k(1, 2), &k(2, 0), &k(2, 1), &k(2, 2)},
                      inputs.quantities);
      EXPECT_LE(of_matrix.above(), largest.scale);
    }
  }
  EXPECT_TRUE(is_least_that_covers(oracles::largest_sensitivity_of_moderate, largest.scale));
  EXPECT_TRUE(is_least_that_covers(oracles::largest_on_the_way_of_moderate, largest.on_the_way));
  EXPECT_LE(std::log2(oracles::largest_on_the_way_of_moderate), std::numeric_limits<double>::max_exponent - 1);
}

/// Inequality (4) for Cramer's rule in binary64. With λ = 1/m_A + 1/m_B, det K ≥ λ³.
TEST(ModerateBounds, CoverTheIntermediateNumbersOfCramersRule) {
  for (const Corner& corner : corners()) {
    if (!corner.is_light) {
      continue;
    }
    const auto inputs = differentiated(collision_at(corner));
    const BasicCollision<Magnitude> c =
        map_numbers<Magnitude>(inputs.collision, [](const MagnitudeDual& x) { return x.value; });
    Magnitude::forget();
    const Magnitude::DivisorsAtLeast theorem(-3 * std::log2(oracles::largest_moderate_mass));
    EXPECT_GT(oracles::cramer<Magnitude>(oracles::response_matrix(c), oracles::wanted_change<oracles::Reflection>(c))[0]
                  .above(),
              0);
    EXPECT_LE(Magnitude::highest(), std::log2(oracles::largest_on_the_way_of_moderate));
  }
}

/// Squares of numbers and of their negatives are positive, but −b² is not.
TEST(Magnitude, HasALowerBoundForASumOfSquaresOnly) {
  const Magnitude a(3);
  const Magnitude b(2);
  EXPECT_FALSE(std::isnan((a * a + b * b).below()));
  EXPECT_FALSE(std::isnan((a * a + -b * -b).below()));
  EXPECT_TRUE(std::isnan((a * a + -(b * b)).below()));
  EXPECT_TRUE(std::isnan((a * a + -b * b).below()));
}

}  // namespace
}  // namespace carom::bounds
