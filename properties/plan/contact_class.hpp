// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <array>
#include <string>
#include <string_view>

#include <carom/collision/collision.hpp>
#include <carom/collision/enum_array.hpp>

namespace carom::properties::plan {

/// The class of a contact, by its geometry and moments. These decide whether a cheaper law, or J⁻¹ in world axes,
/// serves. The classes:
///
///   `both immovable`
///   `central`: Each movable body's lever arm r is parallel to N, within the rounding of P and X
///   `slender`: A movable body's greatest moment is more than 8 times its least
///   `equal moments`: Each movable body has three equal moments
///   `general`: All others.
///
/// If a body is movable, the class is the first of the last four that holds, with ", one immovable" or ", both movable"
/// added. Certificates do not depend on classes. Precondition: the collision is valid.
[[nodiscard]] std::string contact_class_of(const Collision& collision);

/// How a method of Frame::body computes torques for a contact (impulse/principal_inertia.hpp). The moments in binary64
/// decide.
enum class TorqueForm {
  equal,     // all movable bodies have three equal moments: torques stay in world axes
  plain,     // all others without a slender body: plain cross products
  accurate,  // a movable body is slender: each component has a small relative error
};
inline constexpr std::array all_torque_forms{TorqueForm::equal, TorqueForm::plain, TorqueForm::accurate};
static_assert(counts_from_zero_to(all_torque_forms, TorqueForm::accurate));

[[nodiscard]] constexpr std::string_view name_of(TorqueForm form) {
  constexpr EnumArray<TorqueForm, std::string_view, all_torque_forms.size()> names{"equal", "plain", "accurate"};
  return names[form];
}

/// Precondition: the collision is valid.
[[nodiscard]] TorqueForm torque_form_of(const Collision& collision);

}  // namespace carom::properties::plan
