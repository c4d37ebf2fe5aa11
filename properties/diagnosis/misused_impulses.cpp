// SPDX-License-Identifier: BSL-1.0
#include <carom/properties/diagnosis/hypothesis.hpp>

namespace carom::properties::diagnosis {
namespace {

/// `factors` multiply the changes of A's velocity, A's spin, B's velocity and B's spin.
Hypothesis of_factors(std::string as_if, std::string look_at, PerVector<double> factors) {
  return {std::move(as_if), std::move(look_at), {with_factors(factors)}};
}

Hypothesis with_factor(std::string as_if, std::string look_at, double (*factor)(const Collision&)) {
  return {std::move(as_if), std::move(look_at), {[factor](Steps& steps, const KnownCase&) {
            for (const OutcomeVector k : all_outcome_vectors) {
              steps.factors[k] *= factor(steps.computed_from);
            }
            return true;
          }}};
}

Hypothesis dropped(char axis) {
  return {std::string("the ") + axis + " component of the impulse were 0",
          "the components of the impulse",
          {with_steps([axis](Steps& steps, const KnownCase&) { steps.components[axis - 'x'] = 0; })},
          false};
}

Mistake solved_twice(ApproachTest test) {
  return [test](Steps& steps, const KnownCase& one) {
    steps.is_solved_twice = true;
    steps.test = test;
    steps.has_right_impulse = false;
    return one.approach != oracles::ContactState::inert;
  };
}

}  // namespace

std::vector<Hypothesis> misused_impulses() {
  const std::string which_contacts =
      "the condition for solving a contact: thresholds on the approach, sleeping bodies, filters";
  const std::string impulse_on_b = "the application of −F to body B";
  const std::string impulse_on_a = "the application of F to body A";
  const std::string spins = "the computation of the change of spin from r × F";
  const std::string twice = "the list of contacts: a pair that occurs twice, an impulse that is applied twice";
  const std::string length = "the use of the normal as a unit vector: normalise it first, or divide by N·N";
  Hypothesis ignored = of_factors("the contact were ignored", which_contacts, {0, 0, 0, 0});
  ignored.needs_condition = true;  // a wrong V⁻ may separate
  return {
      ignored,
      {"each body bounced alone, with the other one immovable",
       "the response of a pair: both bodies share one impulse",
       {[](Steps& steps, const KnownCase& one) {
         steps.is_each_body_alone = true;
         return !one.collision.a.immovable && !one.collision.b.immovable;
       }}},
      of_factors("B got no reaction at all", impulse_on_b, {1, 1, 0, 0}),
      of_factors("A got no impulse at all", impulse_on_a, {0, 0, 1, 1}),
      of_factors("neither body's spin were changed", spins, {1, 0, 1, 0}),
      of_factors("A's spin were not changed", spins, {1, 0, 1, 1}),
      of_factors("B's spin were not changed", spins, {1, 1, 1, 0}),
      of_factors("only the spins were changed, and no velocity", "the addition of F/m to the velocities", {0, 1, 0, 1}),
      of_factors("A's velocity were not changed", "the addition of F/m to A's velocity", {0, 1, 1, 1}),
      of_factors("B's velocity were not changed", "the subtraction of F/m from B's velocity", {1, 1, 0, 1}),
      of_factors("B were pushed in the same direction as A", "the sign of the impulse on B: it is −F", {1, 1, -1, -1}),
      of_factors("A were pushed in the wrong direction", "the sign of the impulse on A: it is +F, along the normal",
                 {-1, -1, 1, 1}),
      of_factors("both bodies were pushed in the wrong direction", "the direction of the normal: from B to A",
                 {-1, -1, -1, -1}),
      of_factors("A's spin were changed in the wrong direction", "the sign, or the order, of r × F for A",
                 {1, -1, 1, 1}),
      of_factors("B's spin were changed in the wrong direction", "the sign, or the order, of r × (−F) for B",
                 {1, 1, 1, -1}),
      of_factors("both spins were changed in the wrong direction", "the order of r × F", {1, -1, 1, -1}),
      of_factors("B's velocity were changed in the wrong direction", "the sign of F/m for B", {1, 1, -1, 1}),
      of_factors("A's velocity were changed in the wrong direction", "the sign of F/m for A", {-1, 1, 1, 1}),
      of_factors("the impulse were applied twice", twice, {2, 2, 2, 2}),
      dropped('x'),
      dropped('y'),
      dropped('z'),
      {"the impulse were applied twice, the second time for the new velocities",
       twice,
       {solved_twice(ApproachTest::right), solved_twice(ApproachTest::missing)}},
      with_factor("the impulse were multiplied by the length of the normal", length,
                  [](const Collision& c) { return c.normal.norm(); }),
      with_factor("the impulse were multiplied by the squared length of the normal", length,
                  [](const Collision& c) { return c.normal.squaredNorm(); }),
      with_factor("the impulse were divided by the length of the normal", length,
                  [](const Collision& c) { return 1 / c.normal.norm(); }),
      with_factor("the impulse were divided by the squared length of the normal", length,
                  [](const Collision& c) { return 1 / c.normal.squaredNorm(); }),
      with_factor("the impulse were multiplied by 1 + ε twice", "the factor 1 + ε: it occurs twice",
                  [](const Collision& c) { return 1 + c.restitution; }),
      with_factor("the impulse were multiplied by ε", "the factor 1 + ε",
                  [](const Collision& c) { return c.restitution; }),
  };
}

}  // namespace carom::properties::diagnosis
