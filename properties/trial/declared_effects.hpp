// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>

#include <carom/collision/declared_effects.hpp>
#include <carom/collision/law.hpp>
#include <carom/properties/invariants/invariant.hpp>

/// The gate judges a subject that declares effects by the law without these effects. It changes the collision
/// (`judged_collision`), and it takes the effects out of the answer (`take_out_effects`).
namespace carom::properties {

/// "restitution_threshold 0.5 m/s, linear_damping 0.01". Empty if no effect is declared.
[[nodiscard]] std::string to_text(const DeclaredEffects& effects);

/// Throws std::invalid_argument if a size is invalid, or if a limit of speeds is declared for a law that does not
/// determine the outcome.
void require_valid(const DeclaredEffects& effects, Law law);

/// Whether an effect depends on the speed of approach.
[[nodiscard]] bool depend_on_approach(const DeclaredEffects& effects);

/// The collision to which the law gives the answer that `restitution_threshold` and `slop` intend: with ε = 0, or with
/// the reversed normal, so that the contact separates and the law changes nothing. The speed of approach is compared
/// exactly. Precondition: the collision is valid.
[[nodiscard]] Collision judged_collision(const Collision& posed, const DeclaredEffects& effects);

/// Whether permitted rounding of the inputs decides on which side of a declared threshold the speed of approach lies.
[[nodiscard]] bool is_at_declared_limit(const oracles::ExactCase& posed, const DeclaredEffects& effects,
                                        double allowance);

/// Changes the answer to the one before damping and limits of speeds. `judged` is the case of the judged collision. If
/// a limit shortens the law's velocity, the answer's velocity is lengthened by the same factor, up to a relative error
/// of 2⁻¹⁴⁹. Otherwise the result is exact.
///
/// Returns whether the subject may have shortened a velocity: the law's velocity is beyond a limit, or the answer's is
/// at a limit, within the relative difference `allowance`. The length that the subject computed is then unknown, so its
/// rounding does not cancel in the balances of momentum. Precondition: `require_valid` does not throw.
bool take_out_effects(ExactAnswer& answer, const DeclaredEffects& effects, const oracles::ExactCase& judged, Law law,
                      double allowance);

}  // namespace carom::properties
