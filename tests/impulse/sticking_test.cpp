// SPDX-License-Identifier: BSL-1.0
#include <gtest/gtest.h>

#include <carom/impulse/sticking.hpp>
#include <carom/oracles/judge/accuracy.hpp>

namespace carom::impulse {
namespace {

/// B spins fast about its lever arm of 10⁷ m. The rounding errors of w × r are about 200 times as large along z as
/// along x and y. So a correction of N·V must be larger along z.
Collision fast_spin_along_lever_arm() {
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
  return c;
}

TEST(Sticking, KeepsTheDigitsOfEachComponentOfV) {
  const Collision c = fast_spin_along_lever_arm();
  const auto yardstick = oracles::Yardstick::of(Precision::binary64);
  const auto outcome = map_outcome<long double>(sticking<Ldlt>(make_contact<double>(c)),
                                                [](double x) { return static_cast<long double>(x); });
  const oracles::Accuracy accuracy =
      oracles::accuracy(oracles::ExactCase(c), Law::sticking, oracles::LiftedOutcome(outcome), yardstick);
  EXPECT_TRUE(accuracy.is_decided);
  EXPECT_LT(accuracy.backward_error(yardstick.unit_roundoff()), oracles::default_limit_ulps / 2);
}

}  // namespace
}  // namespace carom::impulse
