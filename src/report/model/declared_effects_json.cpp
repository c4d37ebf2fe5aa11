// SPDX-License-Identifier: BSL-1.0
#include <carom/report/model/declared_effects_json.hpp>

namespace carom::report {

using nlohmann::json;

json Json<DeclaredEffects>::write(const DeclaredEffects& effects) {
  json record = json::object();
  for (const DeclaredEffect effect : all_declared_effects) {
    if (effects[effect] != 0) {
      record[std::string(name_of(effect))] = effects[effect];
    }
  }
  return record;
}

DeclaredEffects Json<DeclaredEffects>::read(const Field& field, Reading /*reading*/) {
  DeclaredEffects effects;
  for (const auto& [name, size] : field.members()) {
    const std::optional<DeclaredEffect> effect = declared_effect_named(name);
    if (!effect) {
      size.fail("no field of this name, because it is not an effect that a subject can declare");
    }
    if (!is_valid_size(*effect, size.number())) {
      size.fail(unit_of(*effect).empty() ? "a number above 0 and below 1" : "a positive number");
    }
    effects[*effect] = size.number();
  }
  return effects;
}

}  // namespace carom::report
