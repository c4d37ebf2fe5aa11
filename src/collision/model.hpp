// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

#include <carom/collision/enum_array.hpp>

namespace carom {

/// The law that a subject claims to follow.
enum class Model {
  frictionless,  // the impulse is along the normal (Eberly's note, eq. 18)
  reflection,    // the tangential velocity of the contact point is kept (Eberly's note, eq. 17, 20, 21)
  sticking,  // the contact point stops, except that its normal velocity rebounds: N·V⁺ = −ε N·V⁻, N × V⁺ = 0
  rough,     // Coulomb friction and a tangential restitution e_t (A. Chatterjee, A. Ruina 1998)
  coulomb,   // N·V⁺ = −ε N·V⁻; friction in its cone stops the slip or opposes the remaining slip
  any,       // no particular law: only the rules that hold for every law are judged
};

inline constexpr std::array all_models{Model::frictionless, Model::reflection, Model::sticking,
                                       Model::rough,        Model::coulomb,    Model::any};
static_assert(counts_from_zero_to(all_models, Model::any));

/// A value for each law.
template <class T>
using PerModel = EnumArray<Model, T, all_models.size()>;

/// The laws that determine one outcome by a formula, so that there is a true outcome to compare with. The other laws
/// are judged by their equations.
inline constexpr std::array models_with_truth{Model::frictionless, Model::reflection, Model::sticking, Model::rough};

[[nodiscard]] constexpr bool determines_outcome(Model model) {
  return std::find(models_with_truth.begin(), models_with_truth.end(), model) != models_with_truth.end();
}

[[nodiscard]] constexpr std::string_view name_of(Model model) {
  switch (model) {
    case Model::frictionless:
      return "frictionless";
    case Model::reflection:
      return "reflection";
    case Model::sticking:
      return "sticking";
    case Model::rough:
      return "rough";
    case Model::coulomb:
      return "coulomb";
    case Model::any:
      break;
  }
  return "any";
}

[[nodiscard]] constexpr std::optional<Model> model_named(std::string_view name) {
  for (const Model model : all_models) {
    if (name_of(model) == name) {
      return model;
    }
  }
  return std::nullopt;
}

}  // namespace carom
