// SPDX-License-Identifier: BSL-1.0
#include <cmath>
#include <utility>

#include <carom/properties/features/feature_groups.hpp>

namespace carom::properties::features {
namespace {

using Coefficient = double Collision::*;

Feature exactly(const char* name, Coefficient coefficient, double value, const char* statement, const char* why,
                Limits limits) {
  return {name,
          FeatureKind::special_value,
          statement,
          why,
          {},
          0,
          [=](const Collision& c) { return c.*coefficient == value; },
          [=](Stream&, Collision& c) { c.*coefficient = value; },
          std::move(limits)};
}

/// The coefficient is strictly between `low` and `high`.
Feature between(const char* name, Coefficient coefficient, double low, double high, const char* statement,
                const char* why, Limits limits) {
  return {name,
          FeatureKind::special_value,
          statement,
          why,
          {},
          0,
          [=](const Collision& c) { return c.*coefficient > low && c.*coefficient < high; },
          [=](Stream& stream, Collision& c) { c.*coefficient = low + (high - low) * stream.between(0.0625, 0.9375); },
          std::move(limits)};
}

}  // namespace

std::vector<Feature> of_coefficients() {
  constexpr auto restitution = &Collision::restitution;
  constexpr auto friction = &Collision::friction;
  constexpr auto tangential = &Collision::tangential_restitution;
  constexpr const char* not_read = "only the laws with friction read it; a solver of another law must not";
  return {
      exactly("restitution_zero", restitution, 0, "ε = 0", "no rebound; outcomes vanish (failure case 20)",
              {.kinds_of = {"restitution", "restitution against friction"},
               .only_in = {{"restitution", no_decade, no_decade, is_that_number},
                           {"loss", no_decade, no_decade, "1 − ε is 1"}}}),
      exactly("restitution_one", restitution, 1, "ε = 1", "energy is conserved; 1 − ε vanishes (failure case 48)",
              {.kinds_of = {"restitution", "restitution against friction"},
               .only_in = {{"restitution", no_decade, no_decade, is_that_number},
                           {"loss", no_decade, no_decade, zero_is_in_no_decade}}}),
      exactly("restitution_half", restitution, 0.5, "ε = 1/2", "ε and 1 − ε are equal",
              {.kinds_of = {"restitution"},
               .only_in = {{"restitution", -1, -1, is_that_number}, {"loss", -1, -1, is_that_number}}}),
      exactly("friction_zero", friction, 0, "μ = 0", "the default; a solver may branch on it",
              {.kinds_of = {"friction", "friction against restitution"}}),
      between("friction_some", friction, 0, 1, "0 < μ < 1", not_read, {.kinds_of = {"friction"}}),
      exactly("friction_one", friction, 1, "μ = 1", not_read,
              {.kinds_of = {"friction", "friction against restitution"}}),
      between("friction_great", friction, 8, 1e9, "μ > 8", "μ = ∞ times 0 (failure case 29)",
              {.kinds_of = {"friction", "friction against restitution"}}),
      exactly("tangential_restitution_zero", tangential, 0, "e_t = 0", "the default",
              {.kinds_of = {"tangential restitution"}}),
      between("tangential_restitution_positive", tangential, 0, 1, "0 < e_t < 1", not_read,
              {.kinds_of = {"tangential restitution"}}),
      between("tangential_restitution_negative", tangential, -1, 0, "−1 < e_t < 0", not_read,
              {.kinds_of = {"tangential restitution"}}),
      exactly("tangential_restitution_one", tangential, 1, "e_t = 1", not_read,
              {.kinds_of = {"tangential restitution"}}),
      exactly("tangential_restitution_minus_one", tangential, -1, "e_t = −1", not_read,
              {.kinds_of = {"tangential restitution"}}),
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
       },
       {.kinds_of = {"restitution against friction", "friction against restitution"}}},
  };
}

}  // namespace carom::properties::features
