// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <array>

#include <carom/properties/three_properties.hpp>
#include <carom/properties/trial/in_words.hpp>
#include <carom/properties/trial/trial.hpp>

namespace carom::properties {

std::span<const Property> three_properties() {
  static const std::array all{
      Property{"non_penetrating_post_velocity",
               "Non-penetrating post-velocity",
               "After the impulse, the bodies do not approach at the contact: N·V⁺ ≥ 0.",
               {"non_penetration"}},
      Property{"positive_definiteness",
               "Positive definiteness of C",
               "The collision matrix C of a contact with a movable body is symmetric, and λI ⪯ C with λ = 1/m_A + "
               "1/m_B > 0. It is the matrix of the solve: C F = V⁺ − V⁻.",
               {"definite", "matrix_used"}},
      Property{"momentum_conservation",
               "Momentum conservation",
               "One body gains the linear momentum that the other loses. The change of each body's angular momentum is "
               "the moment of its impulse, so the angular momentum about every point is conserved.",
               {"linear_momentum", "angular_momentum"}}};
  return all;
}

namespace detail {

Ruling ruling(std::string_view property, const Collision& collision, const ReportedOutcome& answer,
              Precision precision) {
  const auto found = std::ranges::find(three_properties(), property, &Property::name);
  Claim claim;
  claim.yardstick.unit_roundoff = unit_roundoff(precision);
  for (const std::string_view name : found->invariants) {
    claim.invariants.push_back(invariant_named(name));
  }
  if (std::holds_alternative<NotFinite>(lift(answer))) {
    return {false, true, "the answer contains infinities or NaN"};
  }
  const JudgedCase judged_case(Case{collision});
  const Judgement judgement = try_case(judged_case, claim, [&](const Collision&) { return lift(answer); });
  if (judgement.unjudged) {
    return {true, false, "not judged: " + std::string(in_words(*judgement.unjudged))};
  }
  Ruling ruling{true, false, {}};
  for (const auto& [invariant, verdict] : judgement.verdicts) {
    if (verdict.status == Status::violated) {
      return {false, true,
              std::string(found->title) + ": " + std::string(invariant->name) + " is violated.\n" +
                  violation_in_words(collision, answer, verdict)};
    }
    if (verdict.status == Status::skipped) {
      ruling.text = verdict.detail;
    }
    ruling.is_in_domain = ruling.is_in_domain || verdict.status == Status::holds;
  }
  return ruling;
}

}  // namespace detail

}  // namespace carom::properties
