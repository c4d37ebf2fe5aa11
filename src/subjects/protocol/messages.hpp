// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <carom/collision/subject.hpp>

/// The lines of the subject protocol, version 1. Each text ends in its line end.
namespace carom::subjects::protocol {

inline constexpr int version = 1;

/// What a subject says of itself.
struct Introduction {
  std::string name;
  std::string version;
  Precision precision = Precision::binary64;
  Model model = Model::any;
  std::vector<std::string> deviates;
  bool matrix = false;  // whether each outcome of a colliding contact has the collision matrix with it

  bool operator==(const Introduction&) const = default;
};

[[nodiscard]] std::string start_request();
/// Precondition: spelling < spelling_count.
[[nodiscard]] std::string solve_request(std::uint64_t id, const Collision& collision, unsigned spelling = 0);
[[nodiscard]] std::string stop_request();

/// The reply to `start`. Throws FormatError.
[[nodiscard]] Introduction introduction_from(std::string_view line);

/// The reply to the `solve` of that number. Where the subject computes in binary32 or binary64, its numbers are read as
/// binary64. A matrix is read where the subject says that it shows one, and passed over elsewhere. Throws FormatError.
[[nodiscard]] Answer answer_from(std::string_view line, std::uint64_t id, Precision precision,
                                 bool shows_matrix = false);

/// Whether a subject of that precision that shows its matrix owes it with this outcome: the contact collides, and a
/// velocity changed. A subject that takes a contact that barely approaches for one that does not, by rounding, forms no
/// matrix.
[[nodiscard]] bool owes_matrix(const Collision& collision, const Outcome<long double>& outcome, Precision precision);

[[nodiscard]] std::string introduction_reply(const Introduction& introduction);
/// A subject that computes in extended is written with all its digits.
[[nodiscard]] std::string answer_reply(std::uint64_t id, const Answer& answer, Precision precision);

}  // namespace carom::subjects::protocol
