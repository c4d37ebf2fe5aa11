// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include <carom/collision/subject.hpp>

/// The lines of `solve` for a subject that says "numbers": "hex" (docs/reference/protocol.md). Each number is the 16
/// hexadecimal digits of its binary64 bits, in the order of carom/collision/doubles.hpp.
namespace carom::subjects::protocol {

/// Appends the request and its line end, because one string for each of many requests is slow.
void add_hex_request(std::string& text, std::uint64_t id, const Collision& collision);

struct HexRequest {
  std::uint64_t id;
  Collision collision;
};

/// Parses a request without its line end. Throws FormatError, which names the place of the error.
[[nodiscard]] HexRequest hex_request_from(std::string_view line);

/// Appends the reply and its line end. Each number is rounded to binary64.
void add_hex_reply(std::string& text, std::uint64_t id, const Answer& answer);

/// Parses the reply to the request with this id. The matrix may follow the outcome only if `shows_matrix`. Throws
/// FormatError, which names the place of the error.
[[nodiscard]] Answer answer_from_hex(std::string_view line, std::uint64_t id, bool shows_matrix);

}  // namespace carom::subjects::protocol
