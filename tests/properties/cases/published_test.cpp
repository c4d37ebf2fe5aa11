// SPDX-License-Identifier: BSL-1.0
#include <gtest/gtest.h>

#include <carom/oracles/judge/coulomb_answers.hpp>
#include <carom/properties/cases/published.hpp>

#include "support/cases.hpp"

namespace carom::properties {
namespace {

using oracles::ExactCase;
using oracles::Rational;

constexpr int cases_of_each = 50;  // for each impact

/// The published answers in ℚ. Sphere A is above B. K = diag(k_t, k_n, k_t), with k_n = Σ 1/m and k_t = Σ (1/m + r²/J)
/// over the spheres. Friction acts along x against the slip u. It slows or stops the slip, but does not reverse it.
struct Published {
  BasicCollision<Rational> c;
  bool has_two_spheres;

  [[nodiscard]] Rational radius() const { return c.a.position.y(); }
  /// k_n.
  [[nodiscard]] Rational mobility_along_normal() const {
    return 1 / c.a.mass + (has_two_spheres ? Rational(1 / c.b.mass) : Rational(0));
  }
  [[nodiscard]] Rational normal_impulse() const {
    return (1 + c.restitution) * (c.b.velocity.y() - c.a.velocity.y()) / mobility_along_normal();
  }
  /// u = V_x⁻. The x component of w × r is −w_z r_y, and r_y is −radius for A and +radius for B.
  [[nodiscard]] Rational slip() const {
    return c.a.velocity.x() - c.b.velocity.x() + radius() * c.a.angular_velocity.z() -
           c.b.position.y() * c.b.angular_velocity.z();
  }
  /// k_t.
  [[nodiscard]] Rational mobility() const {
    const auto of_spin = [](const BasicBody<Rational>& body) -> Rational {
      return body.position.y() * body.position.y() / body.principal_inertia.z();
    };
    return mobility_along_normal() + of_spin(c.a) + (has_two_spheres ? of_spin(c.b) : Rational(0));
  }
  [[nodiscard]] bool slides() const { return abs(slip()) > mobility() * c.friction * normal_impulse(); }
  [[nodiscard]] Rational friction_impulse() const {
    const Rational stops = -slip() / mobility();
    const Rational most = c.friction * normal_impulse();
    return stops > most ? most : stops < -most ? Rational(-most) : stops;
  }
  [[nodiscard]] Vector3<Rational> velocity_of_a() const {
    return {c.a.velocity.x() + friction_impulse() / c.a.mass, c.a.velocity.y() + normal_impulse() / c.a.mass,
            Rational(0)};
  }
  /// J Δw = r × F, whose z component is −r_y F_x with r_y = −radius.
  [[nodiscard]] Rational spin_of_a() const {
    return c.a.angular_velocity.z() + radius() * friction_impulse() / c.a.principal_inertia.z();
  }
};

template <class Check>
void for_each_impact(const Check& check) {
  for (int number = 1; number <= chung_ooi_count; ++number) {
    for (std::uint64_t i = 0; i < cases_of_each; ++i) {
      Stream stream = case_stream(unit::seed, "published", i);
      const Collision collision = chung_ooi_impact(number, stream).collision;
      SCOPED_TRACE(testing::Message() << "impact " << number << ", case " << i);
      check(number, collision, Published{oracles::lift(collision), !collision.b.immovable});
    }
  }
}

TEST(ChungOoi, BothLawsWithFrictionGiveThePublishedAnswers) {
  for_each_impact([](int, const Collision& collision, const Published& published) {
    const ExactCase exact_case(collision);
    const auto expect = [&](const auto& outcome, const auto& in_field) {
      EXPECT_EQ(outcome.a.velocity, published.velocity_of_a().unaryExpr(in_field));
      EXPECT_EQ(outcome.a.angular_velocity.z(), in_field(published.spin_of_a()));
    };
    exact_case.with_truth(Law::rough, exact_case.state(), [&]<class T>(const oracles::Truth<T>& truth) {
      expect(truth.outcome, [](const Rational& x) { return T(x); });
    });
    const std::vector<oracles::CoulombAnswer> answers = oracles::coulomb_answers(exact_case);
    ASSERT_EQ(answers.size(), 1U);
    const auto& after = answers[0].truth.outcome.a;
    const auto near = [](const Rational& x, const Rational& y) {
      return abs(Rational(x - y)) <= Rational(0x1p-100) * abs(y);  // the slip resistance is accurate to 2⁻¹²⁰
    };
    EXPECT_TRUE(near(after.velocity.x(), published.velocity_of_a().x()));
    EXPECT_TRUE(near(after.velocity.y(), published.velocity_of_a().y()));
    EXPECT_TRUE(near(after.angular_velocity.z(), published.spin_of_a()));
  });
}

/// The printed formulas use J = 2/5 m r². In the cases, J differs from 2/5 m r² by a few roundings.
TEST(ChungOoi, TheFormulasAsPrintedHold) {
  int slid = 0;
  for_each_impact([&](int number, const Collision& c, const Published& published) {
    const auto nearest = [](const Rational& x) { return oracles::nearest_double(x); };
    const double approach = c.b.velocity.y() - c.a.velocity.y();
    const double change = c.friction * (1 + c.restitution) * approach;  // k_n times the largest friction impulse
    const double slip = nearest(published.slip());
    const Vector3<double> after = published.velocity_of_a().unaryExpr(nearest);
    const double spin = nearest(published.spin_of_a());
    const auto expect = [](double found, double printed) {
      EXPECT_NEAR(found, printed, 16 * 0x1p-53 * (1 + std::abs(printed)));  // sixteen roundings
    };
    slid += published.slides() ? 1 : 0;
    switch (number) {
      case 1:
        EXPECT_EQ(after.y(), c.b.velocity.y());
        break;
      case 2:
      case 3:
        expect(after.y() / c.a.velocity.y(), -c.restitution);
        break;
      case 4:
        if (published.slides()) {
          expect(after.x() / c.a.velocity.x(), 1 - change / c.a.velocity.x());
        }
        break;
      case 5:
        if (published.slides()) {
          expect(nearest(published.radius()) * spin / (c.friction * approach), -2.5 * (1 + c.restitution));
        }
        break;
      case 7:
        EXPECT_EQ(spin, c.a.angular_velocity.z());
        EXPECT_EQ(after.x(), 0);
        break;
      default:
        if (published.slides()) {
          const Rational slip_after = published.slip() + published.mobility() * published.friction_impulse();
          expect(nearest(slip_after) / slip, 1 - 3.5 * change / std::abs(slip));
        }
    }
  });
  EXPECT_GT(slid, cases_of_each);  // in four of the impacts the sphere can slide
}

}  // namespace
}  // namespace carom::properties
