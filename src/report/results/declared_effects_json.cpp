// SPDX-License-Identifier: BSL-1.0
#include <carom/report/results/declared_effects_json.hpp>

namespace carom::report {
namespace {

using nlohmann::json;

/// A field for each effect that has another value than 0.
template <class Values>
json record_of(const Values& values) {
  json record = json::object();
  for (const DeclaredEffect effect : all_declared_effects) {
    if (values[effect] != 0) {
      record[std::string(name_of(effect))] = values[effect];
    }
  }
  return record;
}

/// The effect with this name. Throws FormatError at `place`.
DeclaredEffect known_effect(const std::string& name, const Field& place) {
  const std::optional<DeclaredEffect> effect = declared_effect_named(name);
  if (!effect) {
    place.fail("no field of this name, because it is not an effect that a subject can declare");
  }
  return *effect;
}

}  // namespace

json Json<DeclaredEffects>::write(const DeclaredEffects& effects) { return record_of(effects); }

DeclaredEffects Json<DeclaredEffects>::read(const Field& field) {
  DeclaredEffects effects;
  for (const auto& [name, size] : field.members()) {
    const DeclaredEffect effect = known_effect(name, size);
    if (!is_valid_size(effect, size.number())) {
      size.fail(unit_of(effect).empty() ? "a number above 0 and below 1" : "a positive number");
    }
    effects[effect] = size.number();
  }
  return effects;
}

json Json<properties::EffectCounts>::write(const properties::EffectCounts& counts) { return record_of(counts); }

properties::EffectCounts Json<properties::EffectCounts>::read(const Field& field) {
  properties::EffectCounts counts{};
  for (const auto& [name, count] : field.members()) {
    counts[known_effect(name, count)] = count.count();
  }
  return counts;
}

}  // namespace carom::report
