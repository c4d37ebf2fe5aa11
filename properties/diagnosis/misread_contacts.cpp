// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include <carom/oracles/laws/kinematics.hpp>
#include <carom/properties/diagnosis/hypothesis.hpp>

namespace carom::properties::diagnosis {
namespace {

using Change = void (*)(Collision&);

Hypothesis of_changed(std::string as_if, std::string look_at, Change change) {
  return {std::move(as_if), std::move(look_at), {computed_as(change)}, false};
}

Hypothesis of_steps(std::string as_if, std::string look_at, std::function<void(Steps&, const KnownCase&)> change) {
  return {std::move(as_if),
          std::move(look_at),
          {with_steps([change = std::move(change)](Steps& steps, const KnownCase& one) {
            change(steps, one);
            steps.has_right_impulse = false;
          })},
          false};
}

const char* const in_float = "the type that numbers are read into: single precision";

template <class... Vectors>
void round(Vectors&... vectors) {
  ((vectors = vectors.template cast<float>().template cast<double>().eval()), ...);
}

void make_practically_immovable(Body& body) {
  body.mass *= 0x1p100;
  body.principal_inertia *= 0x1p100;
}

/// N·V⁻.
double approach_of(const Collision& c) { return c.normal.dot(oracles::relative_velocity<double>(c, unchanged(c))); }

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
       {tested_by(ApproachTest::missing)},
       false},
      {"the test for approach were inverted, so that separating contacts are solved and colliding ones are not",
       condition,
       {tested_by(ApproachTest::inverted)},
       false},
      {"the test for approach left the spins out, and used the velocities of the centres",
       condition,
       {tested_by(ApproachTest::of_centres)},
       false},
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
      of_steps("ε acted on the approach of the centres, without the spins", coefficient,
               [](Steps& steps, const KnownCase&) {
                 Collision& c = steps.computed_from;
                 const double centres = c.normal.dot(c.a.velocity - c.b.velocity);
                 c.restitution *= std::min(centres, 0.0) / approach_of(c);
               }),
      of_steps("ε acted on the whole relative velocity ‖V⁻‖", coefficient,
               [](Steps& steps, const KnownCase&) {
                 Collision& c = steps.computed_from;
                 const Vector3<double> v = oracles::relative_velocity<double>(c, unchanged(c));
                 c.restitution *= -c.normal.stableNorm() * v.stableNorm() / approach_of(c);
               }),
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
      {"the contact point were halfway between the centres",
       "the source of the contact point",
       {misread_as([](Collision& c) { c.point = (c.a.position + c.b.position) / 2; })}},
  };
}

/// The first use of the hypothesis is everywhere, the second the computation, the third the application.
std::vector<Hypothesis> exchanged() {
  struct Exchange {
    const char* as_if;
    const char* look_at;
    Change change;
  };
  const std::array exchanges{
      Exchange{"the heavier body were immovable", "the test for immovable bodies: mass ratios, mass thresholds",
               [](Collision& c) { make_practically_immovable(c.a.mass > c.b.mass ? c.a : c.b); }},
      Exchange{"both masses were swapped", "the body whose mass is read",
               [](Collision& c) { std::swap(c.a.mass, c.b.mass); }},
      Exchange{"the bodies' inertia tensors were swapped", "the body whose inertia is read",
               [](Collision& c) {
                 if (!c.a.immovable && !c.b.immovable) {
                   std::swap(c.a.principal_inertia, c.b.principal_inertia);
                   std::swap(c.a.orientation, c.b.orientation);
                 }
               }},
      Exchange{"the bodies' moments of inertia were swapped", "the body whose inertia is read",
               [](Collision& c) { std::swap(c.a.principal_inertia, c.b.principal_inertia); }},
      Exchange{"the bodies' orientations were swapped", "the body whose orientation is read",
               [](Collision& c) { std::swap(c.a.orientation, c.b.orientation); }},
      Exchange{"the positions were read in binary32", in_float,
               [](Collision& c) { round(c.point, c.a.position, c.b.position); }},
      Exchange{"the velocities were read in binary32", in_float,
               [](Collision& c) { round(c.a.velocity, c.b.velocity, c.a.angular_velocity, c.b.angular_velocity); }}};
  std::vector<Hypothesis> all;
  for (const Exchange& exchange : exchanges) {
    const bool is_of_bodies = exchange.look_at != in_float;
    for (const Use use : {Use::everywhere, Use::computation, Use::application}) {
      if (is_of_bodies || use == Use::everywhere) {
        all.push_back({std::string(exchange.as_if) + words_of(use),
                       exchange.look_at,
                       {misread_in(use, exchange.change)},
                       use != Use::computation});
      }
    }
  }
  return all;
}

std::vector<Hypothesis> misread_matrix() {
  return {of_steps("the entries of the collision matrix K off the diagonal were 0", "the entries of K",
                   [](Steps& steps, const KnownCase&) { steps.matrix.is_diagonal = true; }),
          of_steps("K had 1/(m_A + m_B), the inverse sum of the masses, in place of 1/m_A + 1/m_B", "the masses in K",
                   [](Steps& steps, const KnownCase&) {
                     const Collision& c = steps.computed_from;
                     if (!c.a.immovable && !c.b.immovable) {
                       steps.matrix.added += 1 / (c.a.mass + c.b.mass) - (1 / c.a.mass + 1 / c.b.mass);
                     }
                   })};
}

}  // namespace

std::vector<Hypothesis> misread_contacts() {
  std::vector<Hypothesis> joined;
  for (const auto part : {misread_approach, misread_coefficients, misread_geometry, exchanged, misread_matrix}) {
    std::ranges::move(part(), std::back_inserter(joined));
  }
  return joined;
}

}  // namespace carom::properties::diagnosis
