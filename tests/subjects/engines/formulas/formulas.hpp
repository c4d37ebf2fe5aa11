// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <functional>
#include <map>
#include <string>
#include <string_view>

#include "bullet.hpp"
#include "cannon.hpp"
#include "jolt.hpp"
#include "mujoco.hpp"
#include "ode.hpp"
#include "oimo.hpp"
#include "physx.hpp"
#include "rapier.hpp"

namespace carom::formulas {

using OutcomeOf = std::function<Outcome<double>(const Collision&)>;

namespace detail {

/// The overlap of the spheres with which an adapter poses a contact (src/subjects/engines/npm/posing.mjs): `share`
/// times the longer lever arm [m].
[[nodiscard]] inline double overlap_of(const Collision& collision, double share) {
  const double longer =
      std::max((collision.point - collision.a.position).norm(), (collision.point - collision.b.position).norm());
  return share * (longer > 0 ? longer : 1);
}

}  // namespace detail

/// Whether the subject's engine applies gyroscopic torque, and the subject's formula leaves this torque out.
[[nodiscard]] inline bool leaves_out_gyroscopic_torque(std::string_view subject) {
  return subject.ends_with("as-shipped") && (subject.starts_with("bullet") || subject.starts_with("ode"));
}

/// The formula of the subject with this name; null if there is none.
[[nodiscard]] inline const OutcomeOf* formula_of(std::string_view subject) {
  static const std::map<std::string, OutcomeOf, std::less<>> formulas = [] {
    std::map<std::string, OutcomeOf, std::less<>> all;
    const auto add = [&](const std::string& engine, const auto& formula) {
      all.emplace(engine + "-coulomb", [=](const Collision& c) { return formula(c, true); });
      all.emplace(engine + "-coulomb-as-shipped", [=](const Collision& c) { return formula(c, false); });
    };
    const auto bullet = [](const Collision& c, bool configured) {
      return outcome_of(c, bullet_impulse(c, configured));
    };
    add("bullet-double", bullet);
    add("bullet-float", bullet);
    add("ode-double", [](const Collision& c, bool configured) { return outcome_of(c, ode_impulse(c, configured)); });
    add("rapier", [](const Collision& c, bool configured) {
      const double overlap = detail::overlap_of(c, 1e-5);
      return rapier(c, configured ? rapier_configured(overlap) : rapier_as_shipped(overlap));
    });
    add("jolt", [](const Collision& c, bool configured) {
      return jolt(c, configured ? jolt_configured() : jolt_as_shipped());
    });
    add("cannon", [](const Collision& c, bool configured) {
      const double overlap = detail::overlap_of(c, 64 * std::numeric_limits<double>::epsilon());
      return cannon(c, configured ? cannon_configured(c, overlap) : cannon_as_shipped(overlap));
    });
    add("oimo", oimo);
    add("physx", [](const Collision& c, bool configured) { return physx(c, configured, detail::overlap_of(c, 2e-6)); });
    add("mujoco", [](const Collision& c, bool configured) { return mujoco(c, configured); });
    return all;
  }();
  const auto found = formulas.find(subject);
  return found == formulas.end() ? nullptr : &found->second;
}

}  // namespace carom::formulas
