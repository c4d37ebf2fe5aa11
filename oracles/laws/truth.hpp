// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stdexcept>
#include <string>

#include <carom/collision/law.hpp>
#include <carom/collision/outcome.hpp>

namespace carom::oracles {

/// The answer of a law to a collision, exact if T is an exact field.
template <class T>
struct Truth {
  Vector3<T> impulse;  // F on A, −F on B [N s]
  Outcome<T> outcome;
};

/// Throws std::invalid_argument, for a law that is not one of `laws_with_truth`.
[[noreturn]] inline void determines_no_outcome(Law law) {
  throw std::invalid_argument("the law `" + std::string(name_of(law)) + "` determines no outcome");
}

}  // namespace carom::oracles
