// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stdexcept>
#include <string>

#include <carom/collision/model.hpp>
#include <carom/collision/outcome.hpp>

namespace carom::oracles {

/// The answer of a law to a collision.
template <class T>
struct Truth {
  Vector3<T> impulse;  // F on A, −F on B [N s]
  Outcome<T> outcome;
};

/// Throws std::invalid_argument. Call it for a model that is not one of `models_with_truth`.
[[noreturn]] inline void determines_no_outcome(Model model) {
  throw std::invalid_argument("the model `" + std::string(name_of(model)) + "` determines no outcome");
}

}  // namespace carom::oracles
