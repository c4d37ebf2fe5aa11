// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include <carom/properties/diagnosis/hypothesis.hpp>

namespace carom::properties::diagnosis {
namespace {

using Change = void (*)(Collision&);

Hypothesis of_changed(std::string as_if, std::string look_at, Change change) {
  return {std::move(as_if), std::move(look_at), {misread_as(change)}};
}

void point_from(Vector3<double>& place, const Vector3<double>& point, double factor) {
  place = point - factor * (point - place);
}

void make_practically_immovable(Body& body) {
  body.mass *= 0x1p100;
  body.principal_inertia *= 0x1p100;
}

/// The normal with only its largest component.
Vector3<double> nearest_axis(const Vector3<double>& normal) {
  int largest = 0;
  normal.cwiseAbs().maxCoeff(&largest);
  Vector3<double> axis = Vector3<double>::Zero();
  axis[largest] = normal[largest];
  return axis;
}

std::vector<Hypothesis> misread_approach() {
  const auto tested_by = [](ApproachTest test) -> Mistake {
    return [test](Steps& steps, const KnownCase& one) {
      steps.test = test;
      steps.has_right_impulse = false;
      return one.approach != oracles::ContactState::inert;
    };
  };
  const std::string condition =
      "the condition N·V⁻ < 0: it may be missing, have the wrong sign, or use a V of another point";
  return {
      {"the test for approach were missing, so that separating contacts are solved too",
       condition,
       {tested_by(ApproachTest::missing)}},
      {"the test for approach were inverted, so that separating contacts are solved and colliding ones are not",
       condition,
       {tested_by(ApproachTest::inverted)}},
  };
}

std::vector<Hypothesis> misread_coefficients() {
  const std::string coefficient =
      "the source of the coefficient of restitution: thresholds, defaults, the combination of two coefficients";
  const std::string tangential = "the source and the sign of the tangential restitution";
  return {
      of_changed("ε were 0", coefficient, [](Collision& c) { c.restitution = 0; }),
      of_changed("ε were 1", coefficient, [](Collision& c) { c.restitution = 1; }),
      of_changed("ε were squared", coefficient, [](Collision& c) { c.restitution *= c.restitution; }),
      of_changed("the square root of ε were taken", coefficient,
                 [](Collision& c) { c.restitution = std::sqrt(c.restitution); }),
      of_changed("ε were 1 − ε", coefficient, [](Collision& c) { c.restitution = 1 - c.restitution; }),
      of_changed("ε were replaced by the mean of ε and 1", coefficient,
                 [](Collision& c) { c.restitution = (1 + c.restitution) / 2; }),
      of_changed("the tangential restitution were 0", tangential, [](Collision& c) { c.tangential_restitution = 0; }),
      of_changed("the tangential restitution had the other sign", tangential,
                 [](Collision& c) { c.tangential_restitution = -c.tangential_restitution; }),
      of_changed("the tangential restitution were ε", tangential,
                 [](Collision& c) { c.tangential_restitution = c.restitution; }),
  };
}

std::vector<Hypothesis> misread_geometry() {
  const std::string normal = "changes to the normal before its use: rounding to an axis or a plane, its sign";
  return {
      of_changed("the normal pointed in the other direction", "the direction of the normal: from B to A",
                 [](Collision& c) { c.normal = -c.normal; }),
      of_changed("the normal were replaced by the nearest coordinate axis", normal,
                 [](Collision& c) { c.normal = nearest_axis(c.normal); }),
      of_changed("the normal had no z component", normal, [](Collision& c) { c.normal[2] = 0; }),
      of_changed("the normal had no y component", normal, [](Collision& c) { c.normal[1] = 0; }),
      of_changed("the normal had no x component", normal, [](Collision& c) { c.normal[0] = 0; }),
      of_changed("the normal pointed from B's centre to A's centre", normal,
                 [](Collision& c) { c.normal = c.a.position - c.b.position; }),
      of_changed("the normal pointed from B's centre to the contact point", normal,
                 [](Collision& c) { c.normal = c.point - c.b.position; }),
      of_changed("the contact point were halfway between the centres", "the source of the contact point",
                 [](Collision& c) { c.point = (c.a.position + c.b.position) / 2; }),
      of_changed("both lever arms were doubled", "the lever arms",
                 [](Collision& c) {
                   point_from(c.a.position, c.point, 2);
                   point_from(c.b.position, c.point, 2);
                 }),
      of_changed("both lever arms were halved", "the lever arms",
                 [](Collision& c) {
                   point_from(c.a.position, c.point, 0.5);
                   point_from(c.b.position, c.point, 0.5);
                 }),
      of_changed("the heavier body were immovable", "the test for immovable bodies: mass ratios, mass thresholds",
                 [](Collision& c) { make_practically_immovable(c.a.mass > c.b.mass ? c.a : c.b); }),
      of_changed("both masses were swapped", "the body whose mass is read",
                 [](Collision& c) { std::swap(c.a.mass, c.b.mass); }),
      of_changed("the bodies' moments of inertia were swapped", "the body whose inertia is read",
                 [](Collision& c) { std::swap(c.a.principal_inertia, c.b.principal_inertia); }),
      of_changed("the bodies' orientations were swapped", "the body whose orientation is read",
                 [](Collision& c) { std::swap(c.a.orientation, c.b.orientation); }),
  };
}

std::vector<Hypothesis> limited_mass_ratios() {
  std::vector<Hypothesis> all;
  for (const double ratio : {1e1, 1e2, 1e3, 1e4}) {
    all.push_back({fmt::format("the larger mass were at most {:g} times the smaller one in the computation of the "
                               "impulse; the impulse is applied correctly",
                               ratio),
                   "limits on the ratio of the masses",
                   {computed_as([ratio](Collision& c) {
                     c.a.mass = c.b.immovable ? c.a.mass : std::min(c.a.mass, ratio * c.b.mass);
                     c.b.mass = c.a.immovable ? c.b.mass : std::min(c.b.mass, ratio * c.a.mass);
                   })}});
  }
  return all;
}

}  // namespace

std::vector<Hypothesis> misread_contacts() {
  std::vector<Hypothesis> joined;
  for (const auto part : {misread_approach, misread_coefficients, misread_geometry, limited_mass_ratios}) {
    std::ranges::move(part(), std::back_inserter(joined));
  }
  return joined;
}

}  // namespace carom::properties::diagnosis
