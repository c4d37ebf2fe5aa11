// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/collision/declared_effects.hpp>
#include <carom/properties/gate/declared_effects.hpp>
#include <carom/report/results/archive.hpp>

namespace carom::report {

/// {"restitution_threshold": 0.5}: the size of each declared effect. `read` throws FormatError that names the place.
template <>
struct Json<DeclaredEffects> {
  static nlohmann::json write(const DeclaredEffects& effects);
  static DeclaredEffects read(const Field& field);
};

/// {"restitution_threshold": 12}: the number of cases that each effect decides, if it is not 0.
template <>
struct Json<properties::EffectCounts> {
  static nlohmann::json write(const properties::EffectCounts& counts);
  static properties::EffectCounts read(const Field& field);
};

}  // namespace carom::report
