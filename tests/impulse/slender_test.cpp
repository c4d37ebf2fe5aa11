// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iostream>
#include <limits>
#include <string_view>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <carom/impulse/guaranteed.hpp>
#include <carom/impulse/laws.hpp>
#include <carom/impulse/refined.hpp>
#include <carom/impulse/reflection_in_basis.hpp>
#include <carom/impulse/sticking.hpp>
#include <carom/impulse/world_inertia.hpp>
#include <carom/oracles/exact/rational.hpp>
#include <carom/oracles/judge/accuracy.hpp>
#include <carom/oracles/judge/compare.hpp>
#include <carom/oracles/laws/kinematics.hpp>
#include <carom/properties/cases/body_pairs.hpp>
#include <carom/properties/draws/relative_velocity.hpp>

#include "support/exact.hpp"

/// The cost of world coordinates for slender and flat bodies, whose greatest moment is ρ times the least. In world
/// coordinates, each entry of J⁻¹ = R diag(1/I) Rᵀ has a rounding error of u ‖J⁻¹‖, with the unit roundoff u. J times
/// this error is u ρ. In the body frame, the error is only that of a rotation by the angle u.
namespace carom::impulse {
namespace {

using oracles::Rational;

double ratio_of_moments(const Body& body) {
  return body.principal_inertia.maxCoeff() / body.principal_inertia.minCoeff();
}

/// The body compressed to 2^−exponent along one or two axes. The contact point keeps its place in the material.
Body compressed(const Body& body, const Vector3<double>& point, int axis, bool others, int exponent) {
  const Vector3<double> moments = body.principal_inertia;
  Vector3<double> squares = Vector3<double>::Constant(moments.sum() / 2) - moments;
  Vector3<double> in_body = oracles::turned<double>(oracles::conjugate(body.orientation), point - body.position);
  for (int i = 0; i < 3; ++i) {
    if ((i == axis) != others) {
      squares[i] = std::ldexp(squares[i], -2 * exponent);
      in_body[i] = std::ldexp(in_body[i], -exponent);
    }
  }
  Body result = body;
  result.principal_inertia = {squares[1] + squares[2], squares[0] + squares[2], squares[0] + squares[1]};
  result.position = point - oracles::turned<double>(body.orientation, in_body);
  return result;
}

/// Slivers (slender or flat bodies with least ≤ ρ < 2 least) that hit bodies that are not slender.
std::vector<Collision> slivers(double least, std::size_t count) {
  std::vector<Collision> result;
  properties::Stream stream = properties::stream_from(95);
  const int about = std::ilogb(least) / 2;  // moments scale with the square of a width
  while (result.size() < count) {
    Collision c = properties::convex_bodies(stream).collision;
    c.a = compressed(c.a, c.point, stream.integer(0, 2), stream.chance(2),
                     stream.integer(std::max(0, about - 2), about + 1));
    properties::make_approaching(c);
    const double ratio = ratio_of_moments(c.a);
    if (ratio >= least && ratio < 2 * least && ratio_of_moments(c.b) < 8) {
      result.push_back(c);
    }
  }
  return result;
}

/// The residual of an equation of the law, in ulps of S.
template <class S>
double missed(const oracles::Equation& equation, const Collision& collision, const Outcome<S>& outcome) {
  constexpr double least_that_is_shown = 0x1p-10;
  const auto yardstick = oracles::Yardstick::of(precision_of<S>, {least_that_is_shown});
  const oracles::EquationCheck comparison =
      oracles::compare(equation, oracles::EquationForm::equal, oracles::ExactCase(collision),
                       oracles::LiftedOutcome(reported(outcome)), yardstick);
  return comparison.holds ? 0 : least_that_is_shown * comparison.residual / comparison.allowed;
}

template <class S>
double missed(const Collision& collision, const Outcome<S>& outcome) {
  return std::max({missed(oracles::equation::AngularMomentum{true}, collision, outcome),
                   missed(oracles::equation::AngularMomentum{false}, collision, outcome),
                   missed(oracles::equation::Restitution{}, collision, outcome)});
}

struct Missed {
  double worst = 0;
  int beyond_limit = 0;

  void add(double ulps) {
    worst = std::max(worst, ulps);
    beyond_limit += ulps > oracles::default_limit_ulps ? 1 : 0;
  }
};

template <class S>
class Slivers : public testing::Test {};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(Slivers, Scalars);

constexpr std::array laws{Law::frictionless, Law::reflection, Law::sticking};

template <class S, class Inertia>
Outcome<S> solved(Law law, const Collision& collision) {
  const Contact<S, Inertia> contact = make_contact<S, Inertia>(collision);
  Outcome<S> outcome;
  with_law(law, [&](const auto& solver) { outcome = apply_impulse(contact, solver(contact)); });
  return outcome;
}

TYPED_TEST(Slivers, LoseAngularMomentumInWorldCoordinatesAlone) {
  for (const Law law : laws) {
    for (const double ratio : {8.0, 64.0, 512.0, 8192.0, 131072.0, 1e8}) {
      Missed in_world;
      Missed in_body;
      const std::vector<Collision> cases = slivers(ratio, 300);
      for (const Collision& collision : cases) {
        in_world.add(missed(collision, solved<TypeParam, WorldInertia<TypeParam>>(law, collision)));
        in_body.add(missed(collision, solved<TypeParam, PrincipalInertia<TypeParam>>(law, collision)));
      }
      std::cout << name_of(law) << ", moments 1 : " << ratio << " to twice that, " << cases.size() << " bodies: worst "
                << in_world.worst << " ulps in world coordinates, beyond 32 in " << in_world.beyond_limit << "; worst "
                << in_body.worst << " in the body frame\n";
      EXPECT_LT(in_body.worst, 4) << name_of(law) << ' ' << ratio;
      if (ratio >= 8192) {
        EXPECT_GT(in_world.beyond_limit, 6) << name_of(law) << ' ' << ratio;
      }
    }
  }
}

/// A rod whose tip hits an immovable body. The normal is along the rod, up to rounding.
Collision rod_on_its_tip(properties::Stream& stream, double ratio) {
  Collision c;
  c.b.immovable = true;
  c.a.mass = 12;
  c.a.principal_inertia = {4 / ratio, 4, 4};
  c.a.orientation = stream.quaternion();
  const Vector3<double> axis = oracles::turned<double>(c.a.orientation, Vector3<double>(1, 0, 0));
  c.point = -axis;
  c.b.position = -2 * axis;
  c.normal = axis * stream.between(0.5, 2);
  c.a.velocity = stream.vector() - 10 * axis;
  c.restitution = 0.5;
  return c;
}

template <class S>
oracles::Accuracy accuracy_of(const Collision& c, Law law, const Outcome<S>& outcome) {
  return oracles::accuracy(oracles::ExactCase(c), law, oracles::LiftedOutcome(reported(outcome)),
                           oracles::Yardstick::of(precision_of<S>));
}

template <class S>
double backward_error(const Collision& c, Law law, const Outcome<S>& outcome) {
  return accuracy_of(c, law, outcome).backward_error(oracles::Yardstick::of(precision_of<S>).unit_roundoff());
}

/// Whether the rounding of the positions decides the outcome. For a rod that is thinner than this rounding, any spin
/// about its long axis is permitted.
template <class S>
bool is_blind(const Collision& c) {
  const double allowance = oracles::default_limit_ulps * std::numeric_limits<S>::epsilon() / 2;
  return oracles::ExactCase(c).permitted_inputs(allowance) != nullptr;
}

/// The lever arm, the impulse and the long axis are parallel, so the torque consists of rounding errors. Such a torque
/// would spin the rod about its long axis, ρ times as fast as about another axis.
TYPED_TEST(Slivers, DoNotSpinWhenStruckOnTheirTips) {
  properties::Stream stream = properties::stream_from(97);
  for (const double ratio : {8.0, 64.0, 1e4, 1e6, 1e8}) {
    for (const Law law : laws) {
      double worst = 0;
      double worst_in_world = 0;
      bool is_thinner_than_rounding = false;
      for (int i = 0; i < 100; ++i) {
        const Collision c = rod_on_its_tip(stream, ratio);
        is_thinner_than_rounding = is_thinner_than_rounding || is_blind<TypeParam>(c);
        worst = std::max(worst, backward_error(c, law, solved<TypeParam, PrincipalInertia<TypeParam>>(law, c)));
        worst_in_world =
            std::max(worst_in_world, backward_error(c, law, solved<TypeParam, WorldInertia<TypeParam>>(law, c)));
      }
      std::cout << name_of(law) << ", moments 1 : " << ratio << ": " << worst << " ulps, " << worst_in_world
                << " in world coordinates\n";
      EXPECT_LT(worst, oracles::default_limit_ulps / 4) << name_of(law) << ' ' << ratio;
      if (ratio > 1e5 && law != Law::sticking && !is_thinner_than_rounding) {
        EXPECT_GT(worst_in_world, oracles::default_limit_ulps) << name_of(law) << ' ' << ratio;
      }
    }
  }
}

/// Both bodies have the same lever arm, so exactly the same torque turns both.
TEST(SlenderBodies, ShareTheTorqueWithWhatTurnsAboutTheSamePlace) {
  Collision c;
  c.a.velocity = {0, 0, -1};
  c.b.principal_inertia = {1, 128, 1};
  c.point = {0.001953125, -0.0078125, -0.005859375};
  c.normal = {-0.125, 0.5, 0.375};
  for (const Law law : laws) {
    EXPECT_EQ(missed(oracles::equation::TotalAngularMomentum{}, c, solved<double, PrincipalInertia<double>>(law, c)), 0)
        << name_of(law);
  }
}

/// The lever arms lie exactly along the normal, so no body should turn. But a rounding error in B's part of K would
/// easily turn A.
TEST(SlenderBodies, AreNotTurnedByRoundingInTheMatrixOfTheOtherBody) {
  Collision c;
  c.a.mass = 37961134;
  c.a.principal_inertia = {32158713821, 32158713507, 626};
  c.a.orientation = {0, -1, 0, 1};
  c.a.velocity = {-1, 0, 0};
  c.b.mass = 5e9;
  c.b.principal_inertia = {1136, 1137, 1138};
  c.b.orientation = {0, 2, 1, -1};
  c.point = {0.0001220703125, 0, 0.0009765625};
  c.normal = {0.125, 0, 1};
  for (const Law law : {Law::frictionless, Law::reflection}) {
    EXPECT_LT(backward_error(c, law, solved<double, PrincipalInertia<double>>(law, c)), 4);
  }
}

/// The rounding error of T0 and T1 in a head-on impact must turn no body.
TEST(SlenderBodies, AreNotTurnedByRoundingInATangentBasis) {
  Collision c;
  c.a.mass = 0.4;
  c.a.principal_inertia = {1700, 1600, 2000};
  c.a.orientation = {0.2, -0.64, 0.5, -0.38};
  c.a.position = {-128, 0x1p-23, 0x1p-6};
  c.a.velocity = {2e4, -3e3, 4e3};
  c.a.angular_velocity = {-0.3, -0.1, -0.3};
  c.b.mass = 0.4;
  c.b.principal_inertia = {0.005, 40, 40};
  c.b.orientation = {-1, 0, -0.2, 0};
  c.b.position = {0.5, -0x1p-31, -0x1p-14};
  c.b.velocity = {-9e7, -8e7, 3e7};
  c.b.angular_velocity = {0.3, 0.1, 0.3};
  c.normal = {-1, 0x1p-30, 0x1p-13};
  EXPECT_LT(backward_error(c, Law::reflection, reflection_in_stable_basis(make_contact<double>(c))), 4);
}

TEST(PrincipalInertia, OfEqualMomentsKnowsNoOrientation) {
  const auto inertia = PrincipalInertia<double>::of({2, 2, 2}, {0.3, 0.5, -0.7, 0.1});
  EXPECT_EQ(inertia.axes, Matrix3<double>::Identity());
}

/// After the impulse, rounding may leave an approach of a few ulps. A second impulse against it would change the spin
/// about the long axis by many ulps.
TEST(SlenderBodies, KeepTheirSpinWhereTheApproachIsRoundedAway) {
  for (std::uint64_t i = 0; i < 2000; ++i) {
    properties::Stream stream = properties::case_stream(1, "physical", i);
    const Collision c = properties::convex_bodies(stream).collision;
    with_law(Law::frictionless, [&](const auto& solver) {
      const Outcome<double> outcome = guaranteed(c, make_contact<double>(c), solver);
      EXPECT_LT(backward_error(c, Law::frictionless, outcome), oracles::default_limit_ulps / 2) << i;
    });
  }
}

/// The family `physical` also draws slender bodies, with ρ > 10⁷.
TEST(PhysicalBodies, IncludeSlenderOnes) {
  properties::Stream stream = properties::stream_from(96);
  double largest = 0;
  int beyond_world_coordinates = 0;
  constexpr int count = 5000;
  for (int i = 0; i < count; ++i) {
    const Collision c = properties::convex_bodies(stream).collision;
    largest = std::max({largest, ratio_of_moments(c.a), ratio_of_moments(c.b)});
    beyond_world_coordinates += ratio_of_moments(c.a) > 1e4 ? 1 : 0;
  }
  EXPECT_GT(largest, 1e7);
  EXPECT_GT(beyond_world_coordinates, count / 20);
}

// A body that is struck on its tip along its lever arm. The collision matrix K has the eigenvalue λ = 1/m_A + 1/m_B
// along N, and eigenvalues up to 16 λ across N.

template <class S>
class Tips : public testing::Test {};
TYPED_TEST_SUITE(Tips, Scalars);

/// The cases of `needle_tip` in which the rounding of the positions does not decide the outcome.
template <class S>
std::vector<Collision> struck_tips(std::uint64_t count) {
  std::vector<Collision> tips;
  for (std::uint64_t i = 0; i < count; ++i) {
    const Collision c = unit::case_of("needle_tip", i).collision;
    if (!is_blind<S>(c)) {
      tips.push_back(c);
    }
  }
  return tips;
}

template <class S, class Solver>
double worst_missed_restitution(const std::vector<Collision>& tips, const Solver& solver) {
  double worst = 0;
  for (const Collision& c : tips) {
    const Contact<S> contact = make_contact<S>(c);
    worst = std::max(worst, missed(oracles::equation::Restitution{}, c, apply_impulse(contact, solver(contact))));
  }
  return worst;
}

/// Reflection by one solve without refinement.
template <class S>
ContactImpulse<S> solved_once(const Contact<S>& contact) {
  const S approach = normal_velocity(contact);
  const Vector3<S> change =
      contact.normal * S(-(S(1) + contact.restitution) * approach / dot(contact.normal, contact.normal));
  return contact_impulse(contact, approach < S(0),
                         Ldlt::solve<S>(collision_matrix(contact), change, inverse_mass(contact)));
}

TYPED_TEST(Tips, HoldTheRestitution) {
  const std::vector<Collision> tips = struck_tips<TypeParam>(4000);
  const double once = worst_missed_restitution<TypeParam>(tips, solved_once<TypeParam>);
  std::cout << "worst residual of N·V⁺ in " << tips.size() << " cases: reflection solved once " << once << " ulps";
  for (const Law law : {Law::reflection, Law::sticking, Law::rough}) {
    with_law(law, [&](const auto& solver) {
      const double worst = worst_missed_restitution<TypeParam>(tips, solver);
      std::cout << ", " << name_of(law) << ' ' << worst;
      EXPECT_GT(worst, 0) << name_of(law);
      EXPECT_LT(worst, oracles::default_limit_ulps * 3 / 8) << name_of(law);
      if (law == Law::reflection) {
        EXPECT_LT(worst, once);
      }
    });
  }
  std::cout << '\n';
}

/// The error of J⁻¹ (r × F) × r would be thousands of ulps.
TYPED_TEST(Tips, RespondAsInExactArithmetic) {
  for (std::uint64_t i = 0; i < 500; ++i) {
    const Contact<TypeParam> contact = make_contact<TypeParam>(unit::case_of("needle_tip", i).collision);
    const Contact<Rational> exact = rounded<Rational>(contact);
    const Vector3<Rational> expected = response(exact, exact.normal);
    const Vector3<TypeParam> computed = response(contact, contact.normal);
    double error = 0;
    double size = 0;
    for (int k = 0; k < 3; ++k) {
      error += std::abs(oracles::to_double(Rational(Rational(computed[k]) - expected[k])));
      size += std::abs(oracles::to_double(expected[k]));
    }
    // K has eigenvalues up to 16 λ, and K N is at least λ N. A sum of products has an error of a few roundings.
    EXPECT_LT(error, 4 * 16 * size * std::numeric_limits<TypeParam>::epsilon() / 2) << i;
  }
}

/// A matrix that is singular up to rounding gives no correction, so the impulse stays that of the solve.
TEST(SolvedImpulse, KeepsTheSolutionIfTheCorrectionIsLong) {
  Contact<double> contact = make_contact<double>(unit::ball_on_a_plane(0.5, 0));
  const Matrix3<double> wrong = Matrix3<double>::Identity() * 64;
  const Vector3<double> change{1, 2, 3};
  EXPECT_EQ((solved_impulse<Ldlt>(contact, wrong, change)), (Ldlt::solve<double>(wrong, change, 1)));
}

/// The matrix is 2 % too large, and the change lies along N, where K is small.
TEST(SolvedImpulse, IsRefinedAgainstTheResponseOfTheBodies) {
  Collision c;
  c.b.immovable = true;
  c.a.position = {0, 1, 0};
  c.a.principal_inertia.setConstant(0.05);  // K = diag(21, 1, 21)
  c.a.velocity = {0, -1, 0};
  const Contact<double> contact = make_contact<double>(c);
  const Matrix3<double> exact = collision_matrix(contact);
  const Vector3<double> change{0.125, 2, 0.25};
  const Matrix3<double> greater = exact * 1.02;
  const Vector3<double> impulse = solved_impulse<Ldlt>(contact, greater, change);
  const Vector3<double> missed = exact * impulse - change;
  EXPECT_LT(missed.norm(), 0.001 * change.norm());  // 0.02² of the change, in place of 0.02
  EXPECT_GT(missed.norm(), 0.0001 * change.norm());
}

/// B spins fast about its lever arm of 10⁷ m. The rounding errors of w × r are about 200 times as large along z as
/// along x and y. So a correction of N·V must be larger along z.
TEST(Sticking, KeepsTheDigitsOfEachComponentOfV) {
  Collision c;
  c.a.mass = 512;
  c.a.orientation = {-0.2805385574660211, -0.9092547649170164, -0.6811453929265183, -0.1235343516134777};
  c.a.position = {0.0018157958984375, 0.000316619873046875, -0.001434326171875};
  c.a.velocity = {8.298861757793929e-07, 0, 7.315584298339672e-07};
  c.a.angular_velocity = {-0.00025776028633117676, 0, 0.00029240548610687256};
  c.b.mass = 0.0007790509322512005;
  c.b.principal_inertia = {302294859575.22064, 399531582996.65027, 315576961550.046};
  c.b.orientation = {-0.9289351327930861, -0.5953484391371062, -0.5, 0.95261826273103};
  c.b.position = {-12996943.508340143, 17029800.38885631, 59839.72675346838};
  c.b.velocity = {0, 2.4563632905483246e-08, 0};
  c.b.angular_velocity = {-3249235.8775389846, 4257450.097134923, 14959.931558667387};
  c.point = {0.0018157958984375, 0.000316619873046875, 0.000518798828125};
  c.normal = {-0.750149026066112, 0, -0.6612688097075679};
  c.restitution = 0.0005363347445979721;
  const Outcome<double> outcome = sticking<Ldlt>(make_contact<double>(c));
  EXPECT_TRUE(accuracy_of(c, Law::sticking, outcome).is_decided);
  EXPECT_LT(backward_error(c, Law::sticking, outcome), oracles::default_limit_ulps / 2);
}

// Bodies at the border of slenderness keep their accuracy by plain cross products. Contacts that turn no body take the
// frictionless law.

template <class S>
class NotSlender : public testing::Test {};
TYPED_TEST_SUITE(NotSlender, Scalars);

Vector3<Rational> lifted(const auto& vector) { return {Rational(vector[0]), Rational(vector[1]), Rational(vector[2])}; }

/// max |x_i − y_i|.
template <class S>
double greatest_difference(const Vector3<S>& x, const Vector3<Rational>& y) {
  double greatest = 0;
  for (int i = 0; i < 3; ++i) {
    greatest = std::max(greatest, std::abs(oracles::to_double(Rational(Rational(x[i]) - y[i]))));
  }
  return greatest;
}

/// Moments 1 : x : 8 in any order. The ratio is at the border: the body is not slender.
template <class S>
Vector3<S> moments_at_the_border(properties::Stream& stream) {
  std::array<S, 3> moments{S(1), static_cast<S>(1 + 7 * stream.unit()), S(least_ratio_of_slender_moments)};
  std::swap(moments[0], moments[static_cast<std::size_t>(stream.integer(0, 2))]);
  std::swap(moments[1], moments[static_cast<std::size_t>(stream.integer(1, 2))]);
  return {moments[0], moments[1], moments[2]};
}

/// The error of J⁻¹ τ is at most 32 u ‖τ‖ / min I. Each of three body axes e has an error of at most 4 u, and enters
/// e (e·τ) twice. The products and sums cost at most 8 u.
TYPED_TEST(NotSlender, TurnsABodyAtTheBorderWithinItsBound) {
  using S = TypeParam;
  constexpr double u = std::numeric_limits<S>::epsilon() / 2;
  double worst = 0;
  for (std::uint64_t i = 0; i < 3000; ++i) {
    properties::Stream stream = properties::stream_from(i);
    const Vector3<S> moments = moments_at_the_border<S>(stream);
    const Quaternion<S> orientation = without_extreme_length<S>(stream.quaternion());
    const Vector3<S> torque = stream.direction().cast<S>();
    const auto inertia = PrincipalInertia<S>::of(moments, orientation);
    ASSERT_FALSE(is_slender(inertia)) << i;
    const Matrix3<Rational> inverse = world_inverse_inertia<Rational>(
        lifted(moments),
        {Rational(orientation[0]), Rational(orientation[1]), Rational(orientation[2]), Rational(orientation[3])});
    const double error =
        greatest_difference<S>(detail::turning_by(inertia, detail::in_body_frame(inertia, torque)).change_of_spin,
                               Vector3<Rational>(inverse * lifted(torque)));
    worst = std::max(worst, error / (u * static_cast<double>(torque.norm())));
  }
  std::cout << "worst error in u ‖τ‖ / min I: " << worst << '\n';
  EXPECT_GT(worst, 0);
  EXPECT_LT(worst, 32);
}

/// A body with moments 1 : x : 8 falls on a wall, and is struck nearly along its lever arm. K then has the eigenvalue λ
/// along N, and up to 16 λ across N, so rounding of the torque counts up to 15 times.
TYPED_TEST(NotSlender, HoldsTheRestitutionOfABodyAtTheBorder) {
  using S = TypeParam;
  constexpr double u = std::numeric_limits<S>::epsilon() / 2;
  double worst = 0;
  for (std::uint64_t i = 0; i < 3000; ++i) {
    properties::Stream stream = properties::stream_from(i);
    Contact<S> contact;
    const Vector3<double> direction = stream.direction().normalized();
    const double offset = stream.signed_unit() * std::ldexp(1.0, -stream.integer(0, 60));
    const Vector3<double> r = std::sqrt(15.0) * (direction + offset * Vector3<double>::Unit(stream.integer(0, 2)));
    contact.a = {
        S(1), PrincipalInertia<S>::of(moments_at_the_border<S>(stream), without_extreme_length<S>(stream.quaternion())),
        r.cast<S>(), (5 * direction).cast<S>(), Vector3<S>(stream.direction().cast<S>() * S(0.25))};
    contact.b = {S(0), PrincipalInertia<S>::immovable(), r.cast<S>(), Vector3<S>::Zero(), Vector3<S>::Zero()};
    contact.normal = -direction.cast<S>();
    contact.restitution = S(0.5);
    contact.friction = contact.tangential_restitution = S(0);
    const Contact<Rational> before = rounded<Rational>(contact);
    Contact<Rational> after = before;
    const Outcome<S> outcome = reflection(contact);
    after.a.velocity = lifted(outcome.a.velocity);
    after.a.angular_velocity = lifted(outcome.a.angular_velocity);
    const Rational left = normal_velocity(after) + Rational(contact.restitution) * normal_velocity(before);
    const double change = 1.5 * std::abs(oracles::to_double(normal_velocity(before)));
    worst = std::max(worst, std::abs(oracles::to_double(left)) / (u * change));
  }
  std::cout << "worst residual of N·V⁺ in u |N·ΔV|: " << worst << '\n';
  EXPECT_GT(worst, 0);
  EXPECT_LT(worst, 32);
}

/// Two uniform balls that approach each other. The lever arms are rounded, and then moved across N by `offset` radii.
template <class S>
Contact<S> touching_balls(properties::Stream& stream, double offset) {
  const Vector3<double> normal = stream.direction().normalized();
  const Vector3<double> across = normal.cross(Vector3<double>(stream.unit(), 2, -3)).normalized();
  const auto ball = [&](double side) {
    const double radius = stream.unit() + 0.5;
    const double mass = stream.unit() + 0.5;
    const Vector3<double> r = radius * (-side * normal + offset * across);
    const Vector3<double> v = -side * normal;
    const auto in_s = [](const Vector3<double>& x) { return Vector3<S>(x.template cast<S>()); };
    return ContactBody<S>{static_cast<S>(1 / mass),
                          PrincipalInertia<S>::of(in_s(Vector3<double>::Constant(0.4 * mass * radius * radius)),
                                                  without_extreme_length<S>(stream.quaternion())),
                          in_s(r), in_s(v), in_s(stream.direction())};
  };
  return {ball(1), ball(-1), normal.template cast<S>(), S(0.5), S(0), S(0)};
}

/// Rounding of r × N turns a ball by a few ulps. Such contacts need no collision matrix.
TYPED_TEST(NotSlender, ReflectsBallsByTheFrictionlessLaw) {
  using S = TypeParam;
  int turning = 0;
  for (std::uint64_t i = 0; i < 2000; ++i) {
    properties::Stream stream = properties::stream_from(i);
    const Contact<S> contact = touching_balls<S>(stream, 0);
    if (!detail::turns_no_body(contact, approach_of(contact))) {
      ++turning;
      continue;
    }
    EXPECT_EQ(reflection_impulse(contact).on_a, frictionless_impulse(contact).on_a) << i;
  }
  EXPECT_LT(turning, 20);
}

TYPED_TEST(NotSlender, TurnsBallsThatAreStruckASmallDistanceFromTheirRadius) {
  using S = TypeParam;
  constexpr double few_roundoffs = 16 * std::numeric_limits<S>::epsilon();
  for (std::uint64_t i = 0; i < 2000; ++i) {
    properties::Stream stream = properties::stream_from(i);
    const Contact<S> contact = touching_balls<S>(stream, few_roundoffs);
    EXPECT_FALSE(detail::turns_no_body(contact, approach_of(contact))) << i;
  }
}

/// |r × N| |r| of the wall overflows in float, but its J⁻¹ is 0.
TEST(TurnsNoBody, IgnoresTheLeverArmOfAFarWall) {
  properties::Stream stream = properties::stream_from(1);
  Contact<float> contact = touching_balls<float>(stream, 0.5);
  contact.b.inertia = PrincipalInertia<float>::immovable();
  contact.b.inverse_mass = 0;
  contact.b.lever_arm = {1e20F, 2e20F, 3e20F};
  EXPECT_FALSE(detail::turns_no_body(contact, approach_of(contact)));
}

/// In ℚ nothing is rounded, so the least turning counts.
TEST(TurnsNoBody, CountsTheLeastTurningInExactArithmetic) {
  Contact<Rational> contact = unit::exact_contact(unit::case_of("collinear_spheres", 1).collision);
  EXPECT_TRUE(detail::turns_no_body(contact, approach_of(contact)));
  contact.a.lever_arm += contact.normal.cross(Vector3<Rational>(1, 2, 3)) * unit::two_to(-2000);
  EXPECT_FALSE(detail::turns_no_body(contact, approach_of(contact)));
}

}  // namespace
}  // namespace carom::impulse
