// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include <carom/collision/stepper.hpp>

/// The lines of the protocol for engines in time (docs/reference/protocol.md, "In time"). Each text ends with its line
/// end.
namespace carom::subjects::protocol {

/// Parses the reply to `start` of a program that says "time": true. Sets all fields but `specification` and `open`.
/// Throws FormatError, also if the program does not step.
[[nodiscard]] Stepper stepper_from(std::string_view line);

[[nodiscard]] std::string run_request(std::uint64_t id, const Stepping& stepping);

/// A `run` without a scene: it continues the last run by the steps of this stepping.
[[nodiscard]] std::string continue_request(std::uint64_t id, const Stepping& stepping);

/// A request `save` or `restore`.
[[nodiscard]] std::string state_request(std::uint64_t id, std::string_view command);

/// The error that the reply to a request `save` or `restore` names; no value if it names none. Throws FormatError.
[[nodiscard]] std::optional<Refused> state_reply_from(std::string_view line, std::uint64_t id);

/// Parses the reply to the request with this id. Throws FormatError if it is no reply, or if its states do not fit the
/// request.
[[nodiscard]] SteppingAnswer run_reply_from(std::string_view line, std::uint64_t id, const Stepping& stepping);

}  // namespace carom::subjects::protocol
