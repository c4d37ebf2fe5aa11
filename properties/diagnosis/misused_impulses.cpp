// SPDX-License-Identifier: BSL-1.0
#include <carom/properties/diagnosis/hypothesis.hpp>

namespace carom::properties::diagnosis {
namespace {

/// Factors of the law's changes of the four velocities.
struct Factors {
  double velocity_of_a = 1;
  double spin_of_a = 1;
  double velocity_of_b = 1;
  double spin_of_b = 1;
};

Hypothesis with_factors(std::string as_if, std::string look_at, Factors factors) {
  return {std::move(as_if), std::move(look_at), {[factors](Steps& steps, const KnownCase&) {
            steps.factors[OutcomeVector::velocity_of_a] *= factors.velocity_of_a;
            steps.factors[OutcomeVector::angular_velocity_of_a] *= factors.spin_of_a;
            steps.factors[OutcomeVector::velocity_of_b] *= factors.velocity_of_b;
            steps.factors[OutcomeVector::angular_velocity_of_b] *= factors.spin_of_b;
            return true;
          }}};
}

Hypothesis with_factor(std::string as_if, std::string look_at, double (*factor)(const Collision&)) {
  return {std::move(as_if), std::move(look_at), {[factor](Steps& steps, const KnownCase&) {
            for (const OutcomeVector k : all_outcome_vectors) {
              steps.factors[k] *= factor(steps.computed_from);
            }
            return true;
          }}};
}

}  // namespace

std::vector<Hypothesis> misused_impulses() {
  const std::string which_contacts =
      "the condition for solving a contact: thresholds on the approach, sleeping bodies, filters";
  const std::string impulse_on_b = "the application of −F to body B";
  const std::string impulse_on_a = "the application of F to body A";
  const std::string spins = "the computation of the change of spin from r × F";
  const std::string factor =
      "factors of the scalar impulse: an extra 2 or ½, an impulse that is applied twice, a relaxation factor";
  const std::string length = "the use of the normal as a unit vector: normalise it first, or divide by N·N";
  return {
      with_factors("the contact were ignored: the velocities do not change", which_contacts, {0, 0, 0, 0}),
      {"each body bounced alone, with the other one immovable",
       "the response of a pair: both bodies share one impulse",
       {[](Steps& steps, const KnownCase& one) {
         steps.is_each_body_alone = true;
         return !one.collision.a.immovable && !one.collision.b.immovable;
       }}},
      with_factors("B got no reaction at all", impulse_on_b, {1, 1, 0, 0}),
      with_factors("A got no impulse at all", impulse_on_a, {0, 0, 1, 1}),
      with_factors("neither body's spin were changed", spins, {1, 0, 1, 0}),
      with_factors("A's spin were not changed", spins, {1, 0, 1, 1}),
      with_factors("B's spin were not changed", spins, {1, 1, 1, 0}),
      with_factors("only the spins were changed, and no velocity", "the addition of F/m to the velocities",
                   {0, 1, 0, 1}),
      with_factors("A's velocity were not changed", "the addition of F/m to A's velocity", {0, 1, 1, 1}),
      with_factors("B's velocity were not changed", "the subtraction of F/m from B's velocity", {1, 1, 0, 1}),
      with_factors("B were pushed in the same direction as A", "the sign of the impulse on B: it is −F",
                   {1, 1, -1, -1}),
      with_factors("A were pushed in the wrong direction", "the sign of the impulse on A: it is +F, along the normal",
                   {-1, -1, 1, 1}),
      with_factors("both bodies were pushed in the wrong direction", "the direction of the normal: from B to A",
                   {-1, -1, -1, -1}),
      with_factors("A's spin were changed in the wrong direction", "the sign, or the order, of r × F for A",
                   {1, -1, 1, 1}),
      with_factors("B's spin were changed in the wrong direction", "the sign, or the order, of r × (−F) for B",
                   {1, 1, 1, -1}),
      with_factors("both spins were changed in the wrong direction", "the order of r × F", {1, -1, 1, -1}),
      with_factors("B's velocity were changed in the wrong direction", "the sign of F/m for B", {1, 1, -1, 1}),
      with_factors("A's velocity were changed in the wrong direction", "the sign of F/m for A", {-1, 1, 1, 1}),
      with_factors("the impulse were doubled", factor, {2, 2, 2, 2}),
      with_factors("the impulse were halved", factor, {0.5, 0.5, 0.5, 0.5}),
      with_factors("the change of spin were doubled", spins, {1, 2, 1, 2}),
      with_factors("the change of spin were halved", spins, {1, 0.5, 1, 0.5}),
      with_factors("A's change of spin were doubled", spins, {1, 2, 1, 1}),
      with_factors("B's change of spin were doubled", spins, {1, 1, 1, 2}),
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
