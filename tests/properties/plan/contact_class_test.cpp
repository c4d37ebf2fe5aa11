// SPDX-License-Identifier: BSL-1.0
#include <gtest/gtest.h>

#include <carom/properties/plan/contact_class.hpp>

#include "support/cases.hpp"

namespace carom::properties::plan {
namespace {

TEST(ContactClass, FollowsFromTheGeometryAndTheMoments) {
  Collision c = unit::ball_on_a_plane(0.5, 1);
  EXPECT_EQ(contact_class_of(c), "central, one immovable");
  c.a.position = {0.25, 1, 0};
  EXPECT_EQ(contact_class_of(c), "equal moments, one immovable");
  c.a.principal_inertia = {0.5, 0.5, 0.25};
  EXPECT_EQ(contact_class_of(c), "general, one immovable");
  c.a.principal_inertia = {0.5, 0.5, 0.0625};
  EXPECT_EQ(contact_class_of(c), "general, one immovable") << "1 : 8 is not beyond it";
  c.a.principal_inertia = {0.5, 0.5, 0.0624};
  EXPECT_EQ(contact_class_of(c), "slender, one immovable");
  c.b.immovable = false;
  EXPECT_EQ(contact_class_of(c), "slender, both movable");
  c.a.immovable = c.b.immovable = true;
  EXPECT_EQ(contact_class_of(c), "both immovable");
}

TEST(ContactClass, IsCentralWithinTheRoundingOfThePlaces) {
  Collision c = unit::ball_on_a_plane(0.5, 1);
  c.normal = {1.0 / 3, 2.0 / 3, 2.0 / 3};
  c.point = {10.1, -7.3, 0.9};
  c.a.position = c.point + 0.7 * c.normal;  // rounded, so r × N is not zero
  EXPECT_EQ(contact_class_of(c), "central, one immovable");
  c.a.position[0] += 1e-12;
  EXPECT_EQ(contact_class_of(c), "equal moments, one immovable");
}

TEST(ContactClass, DependsOnMovableBodiesOnly) {
  Collision c = unit::ball_on_a_plane(0.5, 1);
  c.b.position = {5, 7, 9};
  EXPECT_EQ(contact_class_of(c), "central, one immovable");
  c.b.immovable = false;
  EXPECT_EQ(contact_class_of(c), "equal moments, both movable");
}

TEST(TorqueForm, IsThatOfTheLeastSimpleMovableBody) {
  Collision c = unit::ball_on_a_plane(0.5, 1);
  const auto form_of = [&](const Vector3<double>& moments_of_a) {
    c.a.principal_inertia = moments_of_a;
    return torque_form_of(c);
  };
  EXPECT_EQ(form_of({1, 1, 1}), TorqueForm::equal);
  EXPECT_EQ(form_of({1, 2, 2.5}), TorqueForm::plain);
  EXPECT_EQ(form_of({1, 8, 8}), TorqueForm::plain);
  EXPECT_EQ(form_of({1, 8.0000001, 8}), TorqueForm::accurate);
  c.a.immovable = true;
  EXPECT_EQ(torque_form_of(c), TorqueForm::equal);
}

}  // namespace
}  // namespace carom::properties::plan
