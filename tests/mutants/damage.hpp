// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <array>
#include <string_view>

#include <carom/collision/collision.hpp>
#include <carom/collision/enum_array.hpp>
#include <carom/collision/law.hpp>
#include <carom/impulse/contact_impulse.hpp>

namespace carom::mutants {

/// Ways to damage a sound outcome. A conditional mutant (detection.hpp) returns the damaged outcome if its feature is
/// present.
enum class Damage {
  torque_of_a_dropped,
  turning_left_out_of_k,
  restitution_ignored,
  nothing_happens,
  reaction_dropped,
  sign_of_impulse_component,
  sign_of_torque_component,
  component_in_binary32,
  impulse_off,
  impulse_turned,
  spin_along_normal_lost,
  bodies_exchanged,
  last_answer_again,
  not_a_number,
};

inline constexpr std::array all_damages{Damage::torque_of_a_dropped,
                                        Damage::turning_left_out_of_k,
                                        Damage::restitution_ignored,
                                        Damage::nothing_happens,
                                        Damage::reaction_dropped,
                                        Damage::sign_of_impulse_component,
                                        Damage::sign_of_torque_component,
                                        Damage::component_in_binary32,
                                        Damage::impulse_off,
                                        Damage::impulse_turned,
                                        Damage::spin_along_normal_lost,
                                        Damage::bodies_exchanged,
                                        Damage::last_answer_again,
                                        Damage::not_a_number};
static_assert(counts_from_zero_to(all_damages, Damage::not_a_number));

[[nodiscard]] std::string_view name_of(Damage damage);

[[nodiscard]] std::string_view sentence_of(Damage damage);

/// The built-in solver's result for a collision, by a law in binary64.
struct Solution {
  Law law;
  impulse::Contact<double> contact;
  impulse::ContactImpulse<double> impulse;
  Outcome<double> outcome;
};

/// Preconditions: the collision is valid, and the law is one of `laws_with_truth`.
[[nodiscard]] Solution solved(Law law, const Collision& collision);

/// The damaged outcome. `last` is the previous answer.
[[nodiscard]] Outcome<double> damaged(Damage damage, const Solution& sound, const Outcome<double>& last);

/// Whether any number differs. NaN differs from every number; −0 and 0 are equal.
[[nodiscard]] bool differ(const Outcome<double>& x, const Outcome<double>& y);

}  // namespace carom::mutants
