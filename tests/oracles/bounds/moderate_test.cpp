// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <carom/oracles/bounds/moderate.hpp>
#include <carom/oracles/bounds/quantities.hpp>
#include <carom/oracles/bounds/slopes.hpp>
#include <carom/oracles/judge/compare.hpp>
#include <carom/oracles/truths/models.hpp>

#include "covers.hpp"
#include "support/known_collisions.hpp"
#include "support/magnitude.hpp"

/// Checks `is_moderate`, and the constants of oracles/bounds/moderate.hpp by its inequalities (1) to (5). Tests run the
/// laws on collisions whose numbers are all at the limits of `is_moderate`, with `Magnitude`. One of these collisions
/// gives the largest result of all moderate collisions, because the logarithm of a result is convex in the logarithms
/// of the inputs (docs/internals/bounds.md).
namespace carom::bounds {

/// A corner of the moderate domain. Numbers in numerators have the largest size. Masses, moments and directions also
/// occur in denominators, so they have the largest or the smallest size.
struct Corner {
  bool is_light;  // masses and moments are the smallest, else the largest
  double orientation_a;
  double orientation_b;
  double normal;
  bool a_immovable;
  bool b_immovable;
};

std::vector<Corner> corners() {
  using oracles::largest_moderate_direction;
  using oracles::smallest_moderate_direction;
  std::vector<Corner> all;
  for (const bool is_light : {true, false}) {
    for (const double a : {smallest_moderate_direction, largest_moderate_direction}) {
      for (const double b : {smallest_moderate_direction, largest_moderate_direction}) {
        for (const double n : {smallest_moderate_direction, largest_moderate_direction}) {
          for (const int immovable : {0, 1, 2}) {
            all.push_back({is_light, a, b, n, immovable == 1, immovable == 2});
          }
        }
      }
    }
  }
  return all;
}

Collision collision_at(const Corner& corner) {
  constexpr double most = oracles::largest_moderate;
  const Vector3<double> largest{most, most, most};
  Collision c;
  for (Body* body : {&c.a, &c.b}) {
    body->mass = corner.is_light ? oracles::smallest_moderate : oracles::largest_moderate_mass;
    body->principal_inertia.setConstant(corner.is_light ? oracles::smallest_moderate_moment
                                                        : oracles::largest_moderate_moment);
    body->position = largest;
    body->velocity = largest;
    body->angular_velocity = largest;
  }
  c.a.immovable = corner.a_immovable;
  c.b.immovable = corner.b_immovable;
  c.a.orientation.setConstant(corner.orientation_a);
  c.b.orientation.setConstant(corner.orientation_b);
  c.point = largest;
  c.normal.setConstant(corner.normal);
  c.restitution = 1;
  c.friction = most;
  c.tangential_restitution = 1;
  return c;
}

/// Lets all components of a direction except the first be smaller.
template <class Direction>
void leave_one_component(Direction& direction) {
  for (int i = 1; i < direction.size(); ++i) {
    direction[i].value = Magnitude::at_most(std::exp2(direction[i].value.above()));
  }
}

oracles::DualInputs<Magnitude, oracles::collision_inputs> differentiated(const Collision& c) {
  auto inputs = oracles::dual_inputs<Magnitude, oracles::collision_inputs>(c, [](double x) { return Magnitude(x); });
  leave_one_component(inputs.collision.a.orientation);
  leave_one_component(inputs.collision.b.orientation);
  leave_one_component(inputs.collision.normal);
  // The length of a position includes the extent, which may be as large as a moderate number.
  std::size_t first = 0;
  for_each_number(
      [&](const FieldPath& path, const double&) {
        if (path.field == "position" && path.component == 0) {
          for (oracles::Quantity& q : inputs.quantities) {
            q.length += q.first == first ? oracles::largest_moderate : 0;
          }
        }
        ++first;
      },
      c);
  return inputs;
}

Outcome<double> largest_outcome() {
  return map_outcome<double>(Outcome<double>{}, [](double) { return oracles::largest_moderate_outcome; });
}

Magnitude length(const Vector3<Magnitude>& v) { return sqrt(v.squaredNorm()); }

}  // namespace carom::bounds

namespace carom::oracles {

using MagnitudeDual = Dual<bounds::Magnitude, collision_inputs>;

/// Bounds the solution x of K x = b and its derivative dx without Cramer's rule, whose bounds are useless. As λI ⪯ K
/// (ExactCase::is_definite), ‖x‖ ≤ ‖b‖ / λ and ‖dx‖ ≤ (‖db‖ + ‖dK‖ ‖x‖) / λ. λ = 1/m_A + 1/m_B is at least 1/M, with
/// the largest moderate mass M.
template <>
Vector3<MagnitudeDual> cramer<MagnitudeDual>(const Matrix3<MagnitudeDual>& k, const Vector3<MagnitudeDual>& b) {
  using bounds::Magnitude;
  const auto vector = [&](const auto& component) {
    return Vector3<Magnitude>{component(b[0]), component(b[1]), component(b[2])};
  };
  const Magnitude inverse_lambda = Magnitude::of_exponent(std::log2(largest_moderate_mass));
  const Magnitude x = length(vector([](const MagnitudeDual& of) { return of.value; })) * inverse_lambda;
  MagnitudeDual component(x);
  for (std::size_t j = 0; j < collision_inputs; ++j) {
    Magnitude of_matrix(0);
    for (int i = 0; i < 3; ++i) {
      for (int l = 0; l < 3; ++l) {
        of_matrix += k(i, l).derivative[j] * k(i, l).derivative[j];
      }
    }
    const Magnitude of_right = length(vector([&](const MagnitudeDual& of) { return of.derivative[j]; }));
    component.derivative[j] = (of_right + sqrt(of_matrix) * x) * inverse_lambda;
  }
  return Vector3<MagnitudeDual>::Constant(component);
}

}  // namespace carom::oracles

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

namespace carom::oracles {
namespace {

struct ModerateRange {
  double smallest;
  double largest;
};

ModerateRange moderate_range(const std::string& field) {
  if (field == "normal" || field == "orientation") {
    return {smallest_moderate_direction, largest_moderate_direction};
  }
  if (field == "principal_inertia") {
    return {smallest_moderate_moment, largest_moderate_moment};
  }
  return {smallest_moderate, field == "mass" ? largest_moderate_mass : largest_moderate};
}

/// Whether the collision is moderate if the number with this index becomes `number`.
bool is_moderate_with(int index, double number) {
  Collision c = unit::plain_collision();
  int next = 0;
  for_each_number(
      [&](const FieldPath& /*path*/, double& of) {
        if (next++ == index) {
          of = number;
        }
      },
      c);
  return is_moderate(c);
}

TEST(Moderate, EndsAtTheLimitsOfEachNumber) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const Collision plain = unit::plain_collision();
  int index = 0;
  for_each_number(
      [&](const FieldPath& path, const double& /*number*/) {
        const ModerateRange range = moderate_range(std::string(path.field));
        for (const double sign : {1.0, path.field == "mass" ? 1.0 : -1.0}) {
          EXPECT_TRUE(is_moderate_with(index, sign * range.smallest)) << path.text();
          EXPECT_TRUE(is_moderate_with(index, sign * range.largest)) << path.text();
          EXPECT_FALSE(is_moderate_with(index, sign * std::nextafter(range.smallest, 0.0))) << path.text();
          EXPECT_FALSE(is_moderate_with(index, sign * std::nextafter(range.largest, infinity))) << path.text();
        }
        EXPECT_TRUE(path.field == "mass" || is_moderate_with(index, 0)) << path.text();
        ++index;
      },
      plain);
}

/// A body of equal moments J and mass m has the extent √(J / (2m)).
TEST(Moderate, EndsAtTheLimitsOfMomentsAndExtents) {
  for (const bool a : {true, false}) {
    Collision c = unit::plain_collision();
    Body& body = a ? c.a : c.b;
    body.mass = largest_moderate_mass;
    body.principal_inertia.setConstant(largest_moderate_moment);
    EXPECT_TRUE(is_moderate(c));
    body.mass = smallest_moderate;
    body.principal_inertia.setConstant(2 * smallest_moderate * largest_moderate * largest_moderate);
    EXPECT_EQ(extent_of(body), largest_moderate);
    EXPECT_TRUE(is_moderate(c));
    body.principal_inertia *= 1 + 0x1p-40;
    EXPECT_FALSE(is_moderate(c));
  }
}

}  // namespace
}  // namespace carom::oracles
