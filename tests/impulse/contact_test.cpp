// SPDX-License-Identifier: BSL-1.0
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include <carom/impulse/coulomb.hpp>
#include <carom/impulse/frictionless.hpp>
#include <carom/impulse/reflection.hpp>
#include <carom/impulse/reflection_in_basis.hpp>
#include <carom/subjects/methods.hpp>

#include "support/cases.hpp"

namespace carom::impulse {
namespace {

/// Checks that `scaled` is the vector times one power of two, with the largest component in [1/2, 1).
void expect_scaled_by_power_of_two(const Vector3<double>& vector, const Vector3<double>& scaled) {
  const double largest = scaled.cwiseAbs().maxCoeff();
  EXPECT_GE(largest, 0.5);
  EXPECT_LT(largest, 1);
  int from = 0;
  int to = 0;
  std::frexp(vector.cwiseAbs().maxCoeff(), &from);
  std::frexp(largest, &to);
  for (int i = 0; i < 3; ++i) {
    EXPECT_TRUE(unit::same_bits(std::ldexp(scaled[i], from - to), vector[i])) << vector.transpose();
  }
}

TEST(WithoutExtremeLength, IsAnExactPowerOfTwoScaling) {
  properties::Stream stream = properties::stream_from(1);
  for (int i = 0; i < 2000; ++i) {
    Vector3<double> vector = stream.direction();
    // The components differ by factors up to 2^60, so none of them is subnormal after scaling.
    vector[stream.integer(0, 2)] *= std::ldexp(1.0, -stream.integer(0, 60));
    vector *= std::ldexp(1.0, stream.integer(-900, 1000));
    expect_scaled_by_power_of_two(vector, without_extreme_length<double>(vector));
  }
}

TEST(WithoutExtremeLength, ScalesTheLargestAndTheSmallestNumbersToAboutOne) {
  using Limits = std::numeric_limits<double>;
  for (const double x : {Limits::max(), Limits::min(), Limits::denorm_min(), 3 * Limits::denorm_min(), 0.5, 1.0}) {
    expect_scaled_by_power_of_two({x, -x, 0}, without_extreme_length<double>(Vector3<double>{x, -x, 0}));
  }
}

TEST(WithoutExtremeLength, KeepsSquaresInTheRangeOfFloat) {
  for (const double x : {1e300, 1e30, 1e-30, 1e-300}) {
    const Vector3<float> scaled = without_extreme_length<float>(Vector3<double>{x, 2 * x, -x});
    const float squared = scaled.dot(scaled);
    EXPECT_GE(squared, 0.25F);
    EXPECT_LE(squared, 3.0F);
    EXPECT_EQ(scaled[1], 2 * scaled[0]);
    EXPECT_EQ(scaled[2], -scaled[0]);
  }
}

TEST(MakeContact, DoesNotReadTheMassInertiaAndOrientationOfAnImmovableBody) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  Collision c = unit::case_of("driven_wall", 0).collision;
  Body& wall = c.a.immovable ? c.a : c.b;
  wall.mass = nan;
  wall.principal_inertia.setConstant(nan);
  wall.orientation.setConstant(nan);
  const Contact<double> contact = make_contact<double>(c);
  const ContactBody<double>& body = c.a.immovable ? contact.a : contact.b;
  EXPECT_EQ(body.inverse_mass, 0);
  EXPECT_EQ(body.inertia.inverse_moments, Vector3<double>(Vector3<double>::Zero()));
  EXPECT_TRUE(body.inertia.axes.allFinite());
  const Outcome<double> outcome = reflection<Ldlt>(contact);
  EXPECT_TRUE(outcome.a.velocity.allFinite() && outcome.b.angular_velocity.allFinite());
}

/// Whether the reported number is the given one or, in binary32, its rounding.
bool is_unchanged(long double reported, double given, Precision precision) {
  const auto is = [&](long double number) {
    return reported == number && std::signbit(reported) == std::signbit(number);
  };
  return is(given) || (precision == Precision::binary32 && is(static_cast<float>(given)));
}

/// Expects that each method leaves the velocities as they are, except for those with this word in their name.
void expect_unchanged(const std::vector<Collision>& collisions, const std::string& except = "no such name") {
  for (const subjects::Method& method : subjects::methods()) {
    if (method.subject.name.find(except) != std::string::npos) {
      continue;
    }
    Session session = method.subject.open();
    const std::vector<Answer> answers = session(collisions);
    ASSERT_EQ(answers.size(), collisions.size());
    for (std::size_t i = 0; i < collisions.size(); ++i) {
      const auto& outcome = std::get<ReportedOutcome>(answers[i]);
      const Outcome<double> before = carom::unchanged(collisions[i]);
      for (const OutcomeVector k : all_outcome_vectors) {
        for (int j = 0; j < 3; ++j) {
          EXPECT_TRUE(is_unchanged((*vectors(outcome)[k])[j], (*vectors(before)[k])[j], method.subject.precision))
              << method.subject.name << ", collision " << i << ", " << name_of(k) << '[' << j << ']';
        }
      }
    }
  }
}

std::vector<Collision> cases_of(const char* family) {
  std::vector<Collision> collisions;
  for (std::uint64_t i = 0; i < 300; ++i) {
    collisions.push_back(unit::case_of(family, i).collision);
  }
  return collisions;
}

TEST(Solvers, LeaveSeparatingAndInertContactsUnchangedBitForBit) {
  expect_unchanged(cases_of("separating"));
  expect_unchanged(cases_of("both_immovable"));
}

/// Bodies of the family `resting` do not spin. With two components n0 and n1 of N, N·V is n0·(−n1 s) + n1·(n0 s), where
/// s is a power of two. The products round alike and cancel. Methods with a basis normalise N first, so their products
/// may differ.
TEST(Solvers, LeaveRestingContactsUnchangedBitForBit) { expect_unchanged(cases_of("resting"), "basis"); }

TEST(Solvers, KeepTheSignOfZeroWhereNothingHappens) {
  Collision c;
  c.a.velocity = {-0.0, 0.0, -0.0};
  c.b.angular_velocity = {-0.0, -0.0, 0.0};
  expect_unchanged({c});
}

/// The smallest example that gains energy (docs/findings/note.md).
Contact<double> box_on_plane(double tangential_velocity) {
  Collision c;
  c.a.principal_inertia.setConstant(1.0 / 6);
  c.a.position = {-0.5, 0.5, 0};
  c.a.velocity = {tangential_velocity, -1, 0};
  c.b.immovable = true;
  return make_contact<double>(c);
}

/// Head-on, the note's solver answers the frictionless F = (0, 4/5, 0). With any tangential velocity, F = (−3/4, 5/4,
/// 0). The impulses differ by ‖(3/4, −9/20)‖ = 0.87.
TEST(Reflection, IsContinuousWhereTheTangentialVelocityVanishesAndTheNoteIsNot) {
  const double slight = std::ldexp(1.0, -40);
  const auto change = [&](const auto& solver) -> Vector3<double> {
    return solver(box_on_plane(slight)).a.velocity - solver(box_on_plane(0)).a.velocity;
  };
  EXPECT_GT(change([](const auto& contact) { return reflection_in_basis(contact); }).norm(), 0.8);
  const Vector3<double> changed = change([](const auto& contact) { return reflection<Ldlt>(contact); });
  // F depends only on N·V. Adding `slight` to a number below 1 rounds by at most 2^-53.
  EXPECT_LE(changed.norm(), slight * 2);
  EXPECT_GT(changed[0], 0);
}

/// A contact in binary32, with lever arms as if the bodies were 10¹⁰ m from the origin: they are multiples of 512 m.
/// The moments are those of a body of one metre. The condition number of C exceeds 1/u, so the rounded C may be
/// singular.
Contact<float> contact_with_lost_lever_arms(properties::Stream& stream) {
  Collision c;
  c.a.principal_inertia = Vector3<double>{1, 1, 1} * std::ldexp(1.0, -stream.integer(0, 9));
  c.a.principal_inertia[stream.integer(0, 2)] *= 2;
  c.a.position = Vector3<double>{1.0 * stream.integer(-1, 1), 1.0 * stream.integer(-1, 1), 1} * 512;
  c.a.velocity = -c.a.position;
  c.normal = {1.0 * stream.integer(-1, 1), 1.0 * stream.integer(-1, 1), 1};
  c.b.immovable = true;
  return make_contact<float>(c);
}

template <class Solver>
int not_finite(const Solver& solver) {
  properties::Stream stream = properties::stream_from(98);
  int found = 0;
  for (int i = 0; i < 2000; ++i) {
    const Outcome<float> outcome = solver(contact_with_lost_lever_arms(stream));
    found += outcome.a.velocity.allFinite() && outcome.a.angular_velocity.allFinite() ? 0 : 1;
  }
  return found;
}

TEST(Reflection, DividesByNoPivotThatRoundingHasMadeZero) {
  EXPECT_EQ(not_finite([](const auto& contact) { return reflection<Ldlt>(contact); }), 0);
  EXPECT_EQ(not_finite([](const auto& contact) { return reflection_in_stable_basis(contact); }), 0);
  // Without the lower bound of pivots, the same matrices cause division by zero.
  EXPECT_GT(not_finite([](const Contact<float>& contact) {
              const Vector3<float> impulse = Ldlt::solve<float>(
                  printed_collision_matrix(contact, stable_tangent_basis(contact)), Vector3<float>{1, 0, 0});
              return apply_impulse(contact, impulse);
            }),
            0);
}

/// Even if the rounded C has eigenvalues below λ = 1/m_A + 1/m_B, each component of the solution x of C x = b is at
/// most 2 ‖b‖∞ / λ.
TEST(Ldlt, LimitsTheSolutionByTheLeastEigenvalue) {
  properties::Stream stream = properties::stream_from(98);
  const Vector3<float> b{1, 0, 0};
  int beyond = 0;
  for (int i = 0; i < 2000; ++i) {
    const Contact<float> contact = contact_with_lost_lever_arms(stream);
    const Matrix3<float> c = printed_collision_matrix(contact, stable_tangent_basis(contact));
    const float least = inverse_mass(contact);
    ASSERT_LE(Ldlt::solve<float>(c, b, least).cwiseAbs().maxCoeff(), 2 / least);
    beyond += Ldlt::solve<float>(c, b).cwiseAbs().maxCoeff() > 2 / least ? 1 : 0;
  }
  EXPECT_GT(beyond, 0);
}

TEST(TangentBasis, IsOrthonormalWellAwayFromHeadOn) {
  int checked = 0;
  for (std::uint64_t i = 0; i < 200; ++i) {
    const Contact<double> contact = make_contact<double>(unit::case_of("generic", i).collision);
    const Vector3<double> n = contact.normal.normalized();
    const Vector3<double> v = relative_velocity(contact);
    const double v_t = n.cross(v).norm();
    if (v_t < v.norm() / 16) {
      continue;
    }
    ++checked;
    const Matrix3<double> basis = tangent_basis(contact);
    // T0 has fewer than 8 roundings of 2^-53. Their errors grow by the factor ‖V‖ / v_t ≤ 16.
    const double bound = std::ldexp(1.0, -46);
    EXPECT_LE((basis.transpose() * basis - Matrix3<double>::Identity()).cwiseAbs().maxCoeff(), bound) << i;
  }
  EXPECT_GT(checked, 100);
}

TEST(TangentBasis, HasNoTangentsWhereThereIsNoTangentialVelocity) {
  const Matrix3<double> basis = tangent_basis(box_on_plane(0));
  EXPECT_EQ(basis.col(0), (Vector3<double>{0, 1, 0}));
  EXPECT_EQ(basis.col(1), (Vector3<double>{0, 0, 0}));
  EXPECT_EQ(basis.col(2), (Vector3<double>{0, 0, 0}));
}

/// K = diag(3, 1, 3), V⁻ = (−3, −4, 0).
Collision ball_on_a_plane(double friction) { return unit::ball_on_a_plane(0.5, friction); }

TEST(Coulomb, SticksWhereFrictionSufficesAndSlidesElsewhere) {
  for (const auto& [friction, slip, spin] : {std::array{0.25, -2.0, 2.0}, {0.125, -2.25, 1.5}}) {
    const Outcome<double> after = coulomb(make_contact<double>(ball_on_a_plane(friction)));
    EXPECT_TRUE(after.a.velocity.isApprox(Vector3<double>(slip, 2, 0), 0x1p-50)) << after.a.velocity;
    EXPECT_TRUE(after.a.angular_velocity.isApprox(Vector3<double>(0, 0, spin), 0x1p-50)) << after.a.angular_velocity;
  }
}

TEST(Coulomb, HasTheBitsOfFrictionlessWithoutFriction) {
  const auto contact = make_contact<double>(ball_on_a_plane(0));
  const Outcome<double> after = coulomb(contact);
  EXPECT_EQ(after.a.velocity, frictionless(contact).a.velocity);
  EXPECT_EQ(after.a.angular_velocity, frictionless(contact).a.angular_velocity);
}

/// λ = 1/m_A + 1/m_B is finite, but the trace of K is not.
TEST(Coulomb, EndsWhereTheTraceOverflows) {
  Collision c = ball_on_a_plane(0.125);
  c.a.mass = 1e-308;
  c.a.principal_inertia.setConstant(1e-300);
  const Outcome<double> after = coulomb(make_contact<double>(c));
  EXPECT_TRUE(std::isfinite(after.a.velocity.norm())) << after.a.velocity;
}

TEST(Coulomb, LeavesASeparatingContactUnchanged) {
  Collision c = ball_on_a_plane(0.5);
  c.a.velocity[1] = 4;
  EXPECT_EQ(coulomb(make_contact<double>(c)).a.velocity, c.a.velocity);
}

}  // namespace
}  // namespace carom::impulse
