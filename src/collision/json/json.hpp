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

/// What was found where something else was expected; the text names the place, "/a/mass: expected a number, found
/// true".
class FormatError : public std::runtime_error {
 public:
  FormatError(const std::string& place, const std::string& expected)
      : std::runtime_error((place.empty() ? std::string("/") : place) + ": " + expected) {}
  /// Of the text as a whole.
  explicit FormatError(const std::string& what) : std::runtime_error(what) {}
};

/// JSON whose numbers have the bits of long double: a subject's that computes in extended.
using WideJson =
    nlohmann::basic_json<std::map, std::vector, std::string, bool, std::int64_t, std::uint64_t, long double>;

/// Parses JSON, and refuses what it leaves open: a field that stands twice in one object, and nesting deeper than 64
/// levels. Throws FormatError, also where a number leaves the range of binary64.
[[nodiscard]] nlohmann::json parse_json(std::string_view text);

/// The same of what a subject of that precision wrote. Of one that computes in extended a number has the bits of long
/// double; of all others those of binary64, its decimals rounded once, and what leaves the range of binary64 is
/// infinite. An integer within 64 bits is kept as one.
[[nodiscard]] WideJson parse_reply(std::string_view text, Precision precision);

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

/// An outcome of the line protocol: the objects `a` and `b` of a reply, which may have further fields. Numbers as
/// number_from_json reads them. Throws FormatError.
[[nodiscard]] Outcome<long double> outcome_from_json(const WideJson& json);

/// The field C of such a reply: three rows of three numbers. Throws FormatError where it is missing, or something else.
[[nodiscard]] Matrix3<long double> collision_matrix_from_json(const WideJson& json);

}  // namespace carom
