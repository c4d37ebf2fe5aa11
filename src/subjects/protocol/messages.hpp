// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <carom/collision/subject.hpp>

/// The lines of the subject protocol, version 1. Each text ends with its line end.
namespace carom::subjects::protocol {

inline constexpr int version = 1;

/// The longest reason in a reply, `skipped` or `error` [bytes]. Longer ones are cut.
inline constexpr std::size_t longest_reason = 2000;

/// How the requests and replies to `solve` write numbers: as JSON, or as in hex_lines.hpp.
enum class Numbers { decimal, hex };

struct Introduction {
  std::string name;
  std::string version;
  Precision precision = Precision::binary64;
  Law law = Law::any;
  std::vector<std::string> deviates;
  bool matrix = false;  // whether each outcome of a colliding contact includes the collision matrix

  std::string domain = {};  // for which the subject is meant, as in Subject
  DeclaredEffects effects = {};
  Numbers numbers = Numbers::decimal;  // `hex` is not for the precision `extended`

  bool operator==(const Introduction&) const = default;
};

/// The precision with this name. Throws FormatError at "/precision" if there is none.
[[nodiscard]] Precision precision_named(const std::string& name);

/// Gives the subject the name and the claims of its introduction.
void introduce(Subject& subject, const Introduction& introduction);

[[nodiscard]] std::string start_request();
/// `spelling` is one of the ways to write the collision (spelling.hpp). Precondition: spelling < spelling_count.
[[nodiscard]] std::string solve_request(std::uint64_t id, const Collision& collision, unsigned spelling = 0);
[[nodiscard]] std::string stop_request();

/// Parses the reply to `start`. Throws FormatError.
[[nodiscard]] Introduction introduction_from(std::string_view line);

/// Parses the reply to the `solve` request with this id. If the subject computes in binary32 or binary64, its numbers
/// are read as binary64. A matrix is read only if `shows_matrix`. Throws FormatError.
[[nodiscard]] Answer answer_from(std::string_view line, std::uint64_t id, Precision precision,
                                 bool shows_matrix = false);

/// Whether a subject that reports its matrix must report it with this outcome: the contact collides, and the outcome
/// changes a velocity in this precision.
[[nodiscard]] bool owes_matrix(const Collision& collision, const Outcome<long double>& outcome, Precision precision);

[[nodiscard]] std::string introduction_reply(const Introduction& introduction);
/// If the precision is `extended`, the numbers have all their digits.
[[nodiscard]] std::string answer_reply(std::uint64_t id, const Answer& answer, Precision precision);

}  // namespace carom::subjects::protocol
