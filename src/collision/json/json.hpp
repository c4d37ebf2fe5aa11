// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstdint>
#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include <carom/collision/outcome.hpp>
#include <carom/collision/precision.hpp>

namespace carom {

/// An unexpected value in JSON text. The message names its place: "/a/mass: expected a number, found true".
class FormatError : public std::runtime_error {
 public:
  FormatError(const std::string& place, const std::string& expected)
      : std::runtime_error((place.empty() ? std::string("/") : place) + ": " + expected) {}
  /// An error of the text as a whole.
  explicit FormatError(const std::string& what) : std::runtime_error(what) {}
};

/// JSON whose numbers are long double, for the replies of a subject in extended precision.
using WideJson =
    nlohmann::basic_json<std::map, std::vector, std::string, bool, std::int64_t, std::uint64_t, long double>;

/// Parses JSON. Throws FormatError if the text is not JSON, if a number overflows binary64, if a field occurs twice in
/// one object, or if values nest deeper than 64 levels.
[[nodiscard]] nlohmann::json parse_json(std::string_view text);

/// Parses a reply of a subject that computes in `precision`. An integer within 64 bits stays an integer. Any other
/// number becomes a long double if `precision` is `extended`. Otherwise the number is rounded once to binary64, and to
/// infinity beyond the range. Throws FormatError as parse_json does, but not for overflow.
[[nodiscard]] WideJson parse_reply(std::string_view text, Precision precision);

/// A finite number as itself; otherwise "nan", "inf" or "-inf".
[[nodiscard]] nlohmann::json number_to_json(double number);

/// Reads a number as number_to_json writes it. `place` is a JSON pointer for the error message. Throws FormatError.
[[nodiscard]] double number_from_json(const nlohmann::json& json, const std::string& place);

/// An array of three numbers, each as number_to_json writes it.
[[nodiscard]] nlohmann::json vector_to_json(const Vector3<double>& vector);

/// The collision record of the line protocol. Omits the mass, inertia and orientation of an immovable body, and
/// `friction` and `tangential_restitution` if they are +0.
[[nodiscard]] nlohmann::json collision_to_json(const Collision& collision);

/// Reads a collision record, and does not validate its numbers. Throws FormatError if a field is missing, unknown, or
/// of another type.
[[nodiscard]] Collision collision_from_json(const nlohmann::json& json, const std::string& place = {});

/// Reads the objects `a` and `b` of a reply, and ignores further fields. Reads numbers as number_from_json does. Throws
/// FormatError.
[[nodiscard]] Outcome<long double> outcome_from_json(const WideJson& json);

/// Reads the field C of a reply: three rows of three numbers. Throws FormatError if it is missing or has another form.
[[nodiscard]] Matrix3<long double> collision_matrix_from_json(const WideJson& json);

/// The ranges and kinds of a domain as text (`Subject::domain`): "size=0.1:10,mass_ratio=:100,plane=xy" from {"size":
/// [0.1, 10], "mass_ratio": [null, 100], "plane": "xy"}. Does not know which quantities and kinds exist. Throws
/// FormatError.
[[nodiscard]] std::string domain_from_json(const nlohmann::json& domain, const std::string& place = {});

/// The object that `domain_from_json` reads back. "restitution=0.5" gives a range of one value. Throws
/// std::invalid_argument if the text is neither ranges and kinds nor "everything".
[[nodiscard]] nlohmann::json domain_to_json(std::string_view text);

}  // namespace carom
