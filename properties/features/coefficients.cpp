// SPDX-License-Identifier: BSL-1.0
#include <cmath>

#include <carom/properties/features/feature_groups.hpp>

namespace carom::properties::features {
namespace {

using Coefficient = double Collision::*;

Feature exactly(const char* name, Coefficient coefficient, double value, const char* statement, const char* why) {
  return {name,
          FeatureKind::special_value,
          statement,
          why,
          {},
          0,
          [=](const Collision& c) { return c.*coefficient == value; },
          [=](Stream&, Collision& c) { c.*coefficient = value; }};
}

/// The coefficient is strictly between `low` and `high`.
Feature between(const char* name, Coefficient coefficient, double low, double high, const char* statement,
                const char* why) {
  return {name,
          FeatureKind::special_value,
          statement,
          why,
          {},
          0,
          [=](const Collision& c) { return c.*coefficient > low && c.*coefficient < high; },
          [=](Stream& stream, Collision& c) { c.*coefficient = low + (high - low) * stream.between(0.0625, 0.9375); }};
}

}  // namespace

std::vector<Feature> of_coefficients() {
  constexpr auto restitution = &Collision::restitution;
  constexpr auto friction = &Collision::friction;
  constexpr auto tangential = &Collision::tangential_restitution;
  constexpr const char* not_read = "only the laws with friction read it; a solver of another law must not";
  return {
      exactly("restitution_zero", restitution, 0, "ε = 0", "no rebound; outcomes vanish (failure case 20)"),
      exactly("restitution_one", restitution, 1, "ε = 1", "energy is conserved; 1 − ε vanishes (failure case 48)"),
      exactly("restitution_half", restitution, 0.5, "ε = 1/2", "ε and 1 − ε are equal"),
      exactly("friction_zero", friction, 0, "μ = 0", "the default; a solver may branch on it"),
      between("friction_some", friction, 0, 1, "0 < μ < 1", not_read),
      exactly("friction_one", friction, 1, "μ = 1", not_read),
      between("friction_great", friction, 8, 1e9, "μ > 8", "μ = ∞ times 0 (failure case 29)"),
      exactly("tangential_restitution_zero", tangential, 0, "e_t = 0", "the default"),
      between("tangential_restitution_positive", tangential, 0, 1, "0 < e_t < 1", not_read),
      between("tangential_restitution_negative", tangential, -1, 0, "−1 < e_t < 0", not_read),
      exactly("tangential_restitution_one", tangential, 1, "e_t = 1", not_read),
      exactly("tangential_restitution_minus_one", tangential, -1, "e_t = −1", not_read),
      {"restitution_equals_friction",
       FeatureKind::relation,
       "ε = μ, and neither is 0 or 1",
       "the two coefficients may be confused",
       {},
       0,
       [](const Collision& c) { return c.restitution == c.friction && c.restitution != 0 && c.restitution != 1; },
       [](Stream& stream, Collision& c) {
         if (c.restitution == 0 || c.restitution == 1) {
           c.restitution = stream.between(0.125, 0.875);
         }
         c.friction = c.restitution;
       }},
  };
}

}  // namespace carom::properties::features
