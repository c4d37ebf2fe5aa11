// SPDX-License-Identifier: BSL-1.0
#include <cstdint>
#include <optional>
#include <string>

#include <gtest/gtest.h>

#include <carom/impulse/collision_matrix.hpp>
#include <carom/impulse/frictionless.hpp>
#include <carom/impulse/reflection.hpp>
#include <carom/impulse/sticking.hpp>
#include <carom/oracles/exact/rational.hpp>
#include <carom/oracles/laws/equations.hpp>
#include <carom/oracles/truths/superposition.hpp>
#include <carom/properties/draws/stream.hpp>

/// The laws as polynomial identities, proved except for a probability below 10⁻²⁶ (Schwartz–Zippel).
///
/// The solver uses only + − × ÷, so each entry of its outcome is a quotient of polynomials in the numbers of the
/// collision. Each law, cleared of denominators, says that a polynomial p is zero. The test evaluates p at a random
/// point, with each variable uniform among s values. If p is not zero and has degree d, it vanishes there with
/// probability at most d/s.
///
/// Degrees of quotients are written as numerator/denominator. I_A and I_B are the products of the three moments of A
/// and B. D = m_A m_B |q_A|⁴ |q_B|⁴ I_A I_B has degree 2·(1 + 4 + 3) = 16.
///
///  J⁻¹ has degree 6/7. Its entries are sums of R_ri R_ci / I_i, with the rotation R of degree 2/2 and the common
///  denominator |q|⁴ I₁ I₂ I₃.
///
///  K = K̂ / D. The term r·r J⁻¹ of K gives K̂ the degree (2 + 6) + (16 − 7) = 17.
///
///  F = −(1+ε) (N·V⁻) D adj(K̂) N / ((N·N) det K̂): degree (1 + 3 + 16 + 34 + 1) / (2 + 51) = 55/53.
///  The frictionless F = −(1+ε) (N·V⁻) D N / (N·K̂N) has a lower degree.
///
///  Δv = F/m: 55/54. Δw = J⁻¹ (r × F): 62/60.
///
/// Energy has the highest degree: Δwᵀ J Δw is at most (62 + 62 + 5)/(60 + 60 + 4) = 129/124. The common denominator of
/// both bodies is ((N·N) det K̂)² m_A m_B (|q_A|⁴ I_A)² |q_A|⁴ (|q_B|⁴ I_B)² |q_B|⁴, of degree 106 + 2 + 2·(14 + 4) =
/// 144. Over this denominator, the numerator has degree 149. The denominators of the other side of the equation divide
/// this denominator. So d < 256 for every law.
///
/// If the contact does not approach, the test replaces N by −N. So the test evaluates p or p₋, the polynomial p with −N
/// in place of N. The product p p₋ is a polynomial of degree below 512 = 2⁹. With s = 2³² and four independent points,
/// a false law passes with probability at most (2⁹⁻³²)⁴ = 2⁻⁹² < 10⁻²⁶.
namespace carom::properties {
namespace {

using oracles::Rational;
using RationalCollision = BasicCollision<Rational>;
using Vector = Vector3<Rational>;
using Contact = impulse::Contact<Rational>;
using Solver = Outcome<Rational> (*)(const Contact&);

constexpr int points = 4;
constexpr std::uint64_t seed = 20240301;

/// Uniform in the 2³² integers from `lowest` on.
Rational uniform(Stream& stream, double lowest) { return Rational(lowest + static_cast<double>(stream.bits() >> 32U)); }

/// The restitution is any integer, because the identities also hold for restitutions outside [0, 1]. Masses and moments
/// are positive.
RationalCollision random_point(Stream& stream) {
  RationalCollision c;
  for_each_number(
      [&](const FieldPath& path, Rational& number) {
        const bool is_positive = path.field == "mass" || path.field == "principal_inertia";
        number = uniform(stream, is_positive ? 1 : -2147483648.0);
      },
      c);
  if (oracles::normal_velocity_before(c) > 0) {
    c.normal = -c.normal;
  }
  return c;
}

template <int N>
bool is_identity(const oracles::Sides<Rational, N>& sides) {
  return sides.left == sides.right;
}

oracles::Sides<Rational, 3> tangential_equation(const RationalCollision& c, Law law, const Outcome<Rational>& y) {
  switch (law) {
    case Law::frictionless:
      return oracles::equation::FrictionlessDirection{true}(c, y);
    case Law::reflection:
      return oracles::equation::ReflectionPlane{}(c, y);
    case Law::sticking:
      return oracles::equation::Sticks{}(c, y);
    case Law::rough:  // its impulse contains a square root
    case Law::coulomb:
    case Law::any:
      break;
  }
  oracles::determines_no_outcome(law);
}

Rational energy_gain(const RationalCollision& c, Law law) {
  const Matrix3<Rational> k = oracles::response_matrix(c);
  const Vector& n = c.normal;
  const Vector v = oracles::relative_velocity<Rational>(c, unchanged(c));
  const Rational normal_velocity = n.dot(v);
  switch (law) {
    case Law::frictionless:
      // −(1 − ε²) (N·V⁻)² / (2 NᵀKN)
      return -(1 - c.restitution * c.restitution) * normal_velocity * normal_velocity / (2 * n.dot(Vector(k * n)));
    case Law::reflection: {
      // K F = g N with g = −(1+ε) (N·V⁻)/(N·N), so ½ F·(V⁻ + V⁺) = g/2 (2 V⁻ + g N)ᵀ K⁻¹ N
      const Rational change = -(1 + c.restitution) * normal_velocity / n.dot(n);
      const Vector in_response = oracles::cramer<Rational>(k, n);
      return change / 2 * Vector(Rational(2) * v + change * n).dot(in_response);
    }
    case Law::sticking: {
      // ½ (V⁺ᵀ K⁻¹ V⁺ − V⁻ᵀ K⁻¹ V⁻) with V⁺ = −ε (N·V⁻)/(N·N) N
      const Vector after = n * Rational(-c.restitution * normal_velocity / n.dot(n));
      return (after.dot(oracles::cramer<Rational>(k, after)) - v.dot(oracles::cramer<Rational>(k, v))) / 2;
    }
    case Law::rough:
    case Law::coulomb:
    case Law::any:
      break;
  }
  oracles::determines_no_outcome(law);
}

/// The name of a law that the solver's outcome violates at a point. Also reports a solver that never acts.
std::optional<std::string> false_identity(Solver solver, Law law) {
  Stream stream = stream_from(seed);
  for (int i = 0; i < points; ++i) {
    const RationalCollision c = random_point(stream);
    const Outcome<Rational> y = solver(impulse::make_contact<Rational>(c));
    if (!is_identity(oracles::equation::Restitution{}(c, y))) {
      return "restitution";
    }
    if (!is_identity(oracles::equation::LinearMomentum{}(c, y))) {
      return "linear momentum";
    }
    if (!is_identity(oracles::equation::AngularMomentum{true}(c, y)) ||
        !is_identity(oracles::equation::AngularMomentum{false}(c, y)) ||
        !is_identity(oracles::equation::TotalAngularMomentum{}(c, y))) {
      return "angular momentum";
    }
    if (!is_identity(tangential_equation(c, law, y))) {
      return "the law's tangential equation";
    }
    if (oracles::kinetic_energy_gain(c.a, y.a) + oracles::kinetic_energy_gain(c.b, y.b) != energy_gain(c, law)) {
      return "energy";
    }
    if (y.a.velocity == c.a.velocity || y.b.angular_velocity == c.b.angular_velocity) {
      return "a response to the collision";
    }
  }
  return std::nullopt;
}

TEST(PolynomialIdentities, HoldOfEverySolverWhoseLawIsLinear) {
  EXPECT_EQ(false_identity(impulse::frictionless<Rational>, Law::frictionless), std::nullopt);
  EXPECT_EQ(false_identity(impulse::reflection<impulse::Ldlt, Rational>, Law::reflection), std::nullopt);
  EXPECT_EQ(false_identity(impulse::reflection<impulse::Adjugate, Rational>, Law::reflection), std::nullopt);
  EXPECT_EQ(false_identity(impulse::sticking<impulse::Ldlt, Rational>, Law::sticking), std::nullopt);
}

TEST(PolynomialIdentities, DoNotHoldOfASubjectThatReturnsItsInput) {
  const Solver idle = [](const Contact& contact) { return impulse::unchanged(contact); };
  EXPECT_EQ(false_identity(idle, Law::frictionless), "restitution");
  EXPECT_EQ(false_identity(idle, Law::reflection), "restitution");
}

TEST(PolynomialIdentities, TellTheLawsApart) {
  EXPECT_EQ(false_identity(impulse::frictionless<Rational>, Law::reflection), "the law's tangential equation");
  EXPECT_EQ(false_identity(impulse::reflection<impulse::Ldlt, Rational>, Law::sticking),
            "the law's tangential equation");
  EXPECT_EQ(false_identity(impulse::sticking<impulse::Ldlt, Rational>, Law::reflection),
            "the law's tangential equation");
  EXPECT_EQ(false_identity(impulse::reflection<impulse::Ldlt, Rational>, Law::frictionless),
            "the law's tangential equation");
}

/// xᵀKx − λ xᵀx = Σ (Qx)ᵀ J⁻¹ (Qx) over the bodies, with λ = 1/m_A + 1/m_B and Qx = r × x. Each term is uᵀJu ≥ 0 with u
/// = J⁻¹(Qx), so λI ⪯ K. The degree is below 32, because K has degree 17/16 and x enters twice.
TEST(PolynomialIdentities, MakeTheMarginOfTheCollisionMatrixASumOfSquares) {
  Stream stream = stream_from(seed);
  for (int i = 0; i < points; ++i) {
    const RationalCollision c = random_point(stream);
    Vector x;
    for (int k = 0; k < 3; ++k) {
      x[k] = uniform(stream, -2147483648.0);
    }
    const Matrix3<Rational> matrix = impulse::collision_matrix(impulse::make_contact<Rational>(c));
    const Rational lambda = 1 / c.a.mass + 1 / c.b.mass;
    Rational squares(0);
    for (const BasicBody<Rational>* body : {&c.a, &c.b}) {
      const Vector u = oracles::response<Rational>(*body, c.point, x).angular_velocity;
      squares += u.dot(oracles::apply_inertia<Rational>(*body, u));
    }
    EXPECT_EQ(x.dot(Vector(matrix * x)) - lambda * x.dot(x), squares);
    EXPECT_GT(squares, 0);
  }
}

}  // namespace
}  // namespace carom::properties
