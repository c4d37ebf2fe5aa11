// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include <carom/collision/declared_effects.hpp>
#include <carom/collision/enum_array.hpp>
#include <carom/collision/law.hpp>
#include <carom/properties/invariants/invariant.hpp>

/// The gate judges a subject that declares effects by the law without these effects. It changes the collision
/// (`judged_collision`), and it takes the effects out of the answer (`take_out_effects`).
namespace carom::properties {

/// The effects that decide a case. Such an effect hides a part of the law's answer from the judge. A threshold hides ε,
/// a slop the impulse, and a limit the length of a velocity. Damping hides nothing, because the division by 1 − c is
/// exact.
using EffectFlags = EnumArray<DeclaredEffect, bool, all_declared_effects.size()>;
using EffectCounts = EnumArray<DeclaredEffect, std::uint64_t, all_declared_effects.size()>;

[[nodiscard]] bool is_any(const EffectFlags& flags);

/// "restitution_threshold 0.5 m/s, linear_damping 0.01". Empty if no effect is declared.
[[nodiscard]] std::string to_text(const DeclaredEffects& effects);

/// The effects, with those of `named` in place of their sizes: {{"restitution_threshold", 0.5}}. Throws
/// std::invalid_argument if a name is unknown.
[[nodiscard]] DeclaredEffects with_named_effects(DeclaredEffects effects, const std::map<std::string, double>& named);

/// Throws std::invalid_argument if a size is invalid, or if a limit of speeds is declared for a law that does not
/// determine the outcome.
void require_valid(const DeclaredEffects& effects, Law law);

/// Whether an effect depends on the speed of approach.
[[nodiscard]] bool depend_on_approach(const DeclaredEffects& effects);

/// The collision to which the law gives the answer that `restitution_threshold` and `slop` intend: with ε = 0, or with
/// the reversed normal, so that the contact separates and the law changes nothing. The speed of approach is compared
/// exactly. Precondition: the collision is valid.
[[nodiscard]] Collision judged_collision(const Collision& posed, const DeclaredEffects& effects);

/// The effects that make the judged collision differ from the posed one.
[[nodiscard]] EffectFlags changes_between(const Collision& posed, const Collision& judged);

/// The effects for which permitted rounding of the inputs decides on which side of the declared size the speed of
/// approach lies.
[[nodiscard]] EffectFlags at_declared_limit(const oracles::ExactCase& posed, const DeclaredEffects& effects,
                                            double allowance);

/// Changes the answer to the one before damping and limits of speeds. `judged` is the case of the judged collision. If
/// a limit shortens the law's velocity, the answer's velocity is lengthened by the same factor, up to a relative error
/// of 2⁻¹⁴⁹. Otherwise the result is exact.
///
/// Returns the limits by which the subject may have shortened a velocity: the law's velocity is beyond the limit, or
/// the answer's is at the limit, within the relative difference `allowance`. The length that the subject computed is
/// then unknown, so its rounding does not cancel in the balances of momentum. Precondition: `require_valid` does not
/// throw.
EffectFlags take_out_effects(ExactAnswer& answer, const DeclaredEffects& effects, const oracles::ExactCase& judged,
                             Law law, double allowance);

}  // namespace carom::properties
