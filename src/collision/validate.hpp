// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <carom/collision/collision.hpp>

namespace carom {

struct InputError {
  std::string field;     // "a.mass", "normal", …
  std::string expected;  // "a finite number", "greater than 0", …
};

namespace detail {

// A NaN passes these comparisons. `validate` reports it as not finite.
inline void check_body(const std::string& name, const Body& body, std::vector<InputError>& errors) {
  if (body.immovable) {
    return;
  }
  if (body.mass <= 0) {
    errors.push_back({name + ".mass", "greater than 0"});
  }
  for (int i = 0; i < 3; ++i) {
    if (body.principal_inertia[i] <= 0) {
      errors.push_back({name + ".principal_inertia[" + std::to_string(i) + "]", "greater than 0"});
    }
  }
  if ((body.orientation.array() == 0).all()) {
    errors.push_back({name + ".orientation", "a quaternion of nonzero length"});
  }
}

/// Whether every number is finite: a fast test.
[[nodiscard]] inline bool is_finite(const Collision& collision) {
  bool is_finite = true;
  for_each_number([&](const FieldPath&, const double& number) { is_finite &= number - number == 0; }, collision);
  return is_finite;
}

inline void check_range(const char* field, double value, double low, double high, const char* expected,
                        std::vector<InputError>& errors) {
  if (value < low || value > high) {
    errors.push_back({field, expected});
  }
}

}  // namespace detail

/// Every error of a collision; empty if the collision is valid.
[[nodiscard]] inline std::vector<InputError> validate(const Collision& collision) {
  std::vector<InputError> errors;
  if (!detail::is_finite(collision)) {
    for_each_number(
        [&](const FieldPath& path, const double& number) {
          if (!std::isfinite(number)) {
            errors.push_back({path.text(), "a finite number"});
          }
        },
        collision);
  }
  detail::check_body("a", collision.a, errors);
  detail::check_body("b", collision.b, errors);
  if ((collision.normal.array() == 0).all()) {
    errors.push_back({"normal", "a vector of nonzero length"});
  }
  constexpr double infinity = std::numeric_limits<double>::infinity();
  detail::check_range("restitution", collision.restitution, 0, 1, "a number from 0 to 1", errors);
  detail::check_range("friction", collision.friction, 0, infinity, "at least 0", errors);
  detail::check_range("tangential_restitution", collision.tangential_restitution, -1, 1, "a number from -1 to 1",
                      errors);
  return errors;
}

/// The errors in one line: "a.mass: expected greater than 0; normal: expected …".
[[nodiscard]] inline std::string describe(const std::vector<InputError>& errors) {
  std::string text;
  for (const InputError& error : errors) {
    text += (text.empty() ? "" : "; ") + error.field + ": expected " + error.expected;
  }
  return text;
}

}  // namespace carom
