// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stdexcept>
#include <string>

#include <nlohmann/json.hpp>

#include <carom/collision/outcome.hpp>

namespace carom {

/// What was found where something else was expected; the text names the place, "/a/mass: expected a number, found
/// true".
class FormatError : public std::runtime_error {
 public:
  FormatError(const std::string& place, const std::string& expected)
      : std::runtime_error((place.empty() ? std::string("/") : place) + ": " + expected) {}
};

/// A finite number as itself; what JSON has no number for as "nan", "inf" or "-inf".
[[nodiscard]] nlohmann::json number_to_json(double number);

/// The other way round. `place` is a JSON pointer, for the error. Throws FormatError.
[[nodiscard]] double number_from_json(const nlohmann::json& json, const std::string& place);

/// Three numbers. Throws FormatError.
[[nodiscard]] nlohmann::json vector_to_json(const Vector3<double>& vector);

/// The collision record of the line protocol; what an immovable body does not have, and friction fields at their
/// defaults, are left out.
[[nodiscard]] nlohmann::json collision_to_json(const Collision& collision);

/// Throws FormatError where a field is missing, unknown, or of another type. Does not validate the numbers.
[[nodiscard]] Collision collision_from_json(const nlohmann::json& json, const std::string& place = {});

}  // namespace carom
