// SPDX-License-Identifier: BSL-1.0
#include <carom/properties/diagnosis/hypothesis_groups.hpp>

namespace carom::properties::diagnosis {
namespace {

/// Of each of the four vectors, so many times its change by the law.
struct Factors {
  double velocity_of_a = 1;
  double spin_of_a = 1;
  double velocity_of_b = 1;
  double spin_of_b = 1;
};

Outcome<double> changed_by(const KnownCase& one, const Factors& factors) {
  const PerVector<double> of_vector{factors.velocity_of_a, factors.spin_of_a, factors.velocity_of_b, factors.spin_of_b};
  Outcome<double> outcome = one.before;
  const auto truth = vectors(one.truth);
  const auto before = vectors(one.before);
  const auto into = vectors(outcome);
  for (const OutcomeVector k : all_outcome_vectors) {
    *into[k] += of_vector[k] * (*truth[k] - *before[k]);
  }
  return outcome;
}

Hypothesis with_factors(std::string as_if, std::string look_at, Factors factors) {
  return {std::move(as_if), std::move(look_at),
          [factors](const KnownCase& one) -> std::optional<Outcome<double>> { return changed_by(one, factors); }};
}

Hypothesis with_factor(std::string as_if, std::string look_at, double (*factor)(const Collision&)) {
  return {std::move(as_if), std::move(look_at), [factor](const KnownCase& one) -> std::optional<Outcome<double>> {
            const double f = factor(one.collision);
            return changed_by(one, {f, f, f, f});
          }};
}

}  // namespace

std::vector<Hypothesis> misused_impulses() {
  const std::string which_contacts =
      "the condition on which a contact is solved at all: thresholds on the approach, sleeping bodies, filters";
  const std::string impulse_on_b = "what is done with −F on body B, after the impulse F on A is known";
  const std::string impulse_on_a = "what is done with F on body A";
  const std::string spins = "where r × F is turned into a change of spin";
  const std::string factor =
      "factors of the scalar impulse: a 2 or a ½ too many, an impulse applied twice, a relaxation factor";
  const std::string length = "where the normal is taken for a unit vector: normalise it first, or divide by N·N";
  return {
      with_factors("the contact were left out: the velocities are those before", which_contacts, {0, 0, 0, 0}),
      with_factors("B got no reaction at all", impulse_on_b, {1, 1, 0, 0}),
      with_factors("A got no impulse at all", impulse_on_a, {0, 0, 1, 1}),
      with_factors("no body's spin were changed", spins, {1, 0, 1, 0}),
      with_factors("A's spin were not changed", spins, {1, 0, 1, 1}),
      with_factors("B's spin were not changed", spins, {1, 1, 1, 0}),
      with_factors("no body's velocity were changed, their spins alone", "where F/m is added", {0, 1, 0, 1}),
      with_factors("A's velocity were not changed", "where F/m is added to A", {0, 1, 1, 1}),
      with_factors("B's velocity were not changed", "where F/m is subtracted from B", {1, 1, 0, 1}),
      with_factors("B were pushed the same way as A", "the sign of the impulse on B: it is −F", {1, 1, -1, -1}),
      with_factors("A were pushed the wrong way", "the sign of the impulse on A: it is +F, along the normal",
                   {-1, -1, 1, 1}),
      with_factors("both bodies were pushed the wrong way", "the side that the normal points to: from B to A",
                   {-1, -1, -1, -1}),
      with_factors("A's spin were changed the wrong way", "the sign, or the order, of r × F for A", {1, -1, 1, 1}),
      with_factors("B's spin were changed the wrong way", "the sign, or the order, of r × (−F) for B", {1, 1, 1, -1}),
      with_factors("both spins were changed the wrong way", "the order of r × F", {1, -1, 1, -1}),
      with_factors("B's velocity were changed the wrong way", "the sign of F/m for B", {1, 1, -1, 1}),
      with_factors("A's velocity were changed the wrong way", "the sign of F/m for A", {-1, 1, 1, 1}),
      with_factors("the impulse were twice what it is", factor, {2, 2, 2, 2}),
      with_factors("the impulse were half of what it is", factor, {0.5, 0.5, 0.5, 0.5}),
      with_factors("the change of spin were twice what it is", spins, {1, 2, 1, 2}),
      with_factors("the change of spin were half of what it is", spins, {1, 0.5, 1, 0.5}),
      with_factors("A's change of spin were twice what it is", spins, {1, 2, 1, 1}),
      with_factors("B's change of spin were twice what it is", spins, {1, 1, 1, 2}),
      with_factor("the impulse were multiplied by the length of the normal", length,
                  [](const Collision& c) { return c.normal.norm(); }),
      with_factor("the impulse were multiplied by the squared length of the normal", length,
                  [](const Collision& c) { return c.normal.squaredNorm(); }),
      with_factor("the impulse were divided by the length of the normal", length,
                  [](const Collision& c) { return 1 / c.normal.norm(); }),
      with_factor("the impulse were divided by the squared length of the normal", length,
                  [](const Collision& c) { return 1 / c.normal.squaredNorm(); }),
      with_factor("the impulse were multiplied by 1 + ε once more", "the factor 1 + ε: it is there twice",
                  [](const Collision& c) { return 1 + c.restitution; }),
      with_factor("the impulse were multiplied by ε", "the factor 1 + ε",
                  [](const Collision& c) { return c.restitution; }),
  };
}

}  // namespace carom::properties::diagnosis
