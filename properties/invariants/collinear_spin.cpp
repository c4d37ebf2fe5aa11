// SPDX-License-Identifier: BSL-1.0
#include <array>

#include <carom/properties/invariants/invariant_groups.hpp>
#include <carom/properties/invariants/untouched.hpp>

namespace carom::properties {
namespace {

constexpr std::array spins{OutcomeVector::angular_velocity_of_a, OutcomeVector::angular_velocity_of_b};

Verdict check_collinear_spin(const Evidence& e) {
  if (e.exact_case.approach() != oracles::Approach::colliding) {
    return outside_domain("the contact is not colliding");
  }
  if (!e.exact_case.is_collinear()) {
    return outside_domain("a lever arm is not along the normal");
  }
  if (is_surely_untouched(e.exact_case, e.outcome, e.yardstick, spins)) {
    return {};
  }
  const oracles::Sensitivity sensitivity = e.exact_case.sensitivity_with_noise(e.law, e.yardstick);
  Verdict worst;
  for (const OutcomeVector k : spins) {
    worst = both(std::move(worst), vector_untouched(e, k, sensitivity));
  }
  return worst;
}

}  // namespace

std::vector<Invariant> collinear_spin_invariants() {
  return {Invariant{"collinear_spin",
                    "If both lever arms are along the normal, as for spheres, no body changes its spin.",
                    R"(r_A \times N = r_B \times N = 0 \Rightarrow w_A^+ = w_A^-,\ w_B^+ = w_B^-)", "note eq. 19",
                    "colliding contacts with both lever arms exactly along the normal",
                    std::vector{Law::frictionless, Law::reflection}, AboutOutcome{check_collinear_spin},
                    Proof{ProvedOf::its_laws,
                          {{"collinear_spin_of_frictionless", "laws_of_impulse.v"},
                           {"collinear_spin_of_reflection", "laws_of_impulse.v"}}}}};
}

}  // namespace carom::properties
