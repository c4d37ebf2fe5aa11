// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <carom/collision/collision.hpp>

/// How a collision is written, where docs/reference/protocol.md leaves that free. What it says, and what is free by it:
///   - "JSON Lines …, one object a line": the order of fields, and blanks between what JSON tells apart.
///   - "Numbers are JSON numbers that round-trip binary64": 2, 2.0 and 2e0; 0.0015, 1.5e-3 and 1.5E-03.
///   - "default 1, 0, 0, 0", "default 0", "default false": a field at its default may be left out.
namespace carom::subjects::protocol {

/// Each collision has so many spellings; 0 is the plain one, with fields in the order of the protocol's example,
/// defaults left out, and the shortest numbers. The others are drawn from the collision's bits.
inline constexpr unsigned spelling_count = 4;

/// The collision as one JSON object. Every spelling is read as the same bits, by whoever reads decimals to the nearest
/// binary64 number. Precondition: spelling < spelling_count.
[[nodiscard]] std::string spelt(const Collision& collision, unsigned spelling);

/// A number of the collision's bits: those of the same collision, and of few others.
[[nodiscard]] std::uint64_t hash_of(const Collision& collision);

/// The ways to write the number that JSON admits and that are told apart here, the shortest first: with a fraction, as
/// an integer where it is a whole one below 2⁵³ (not −0, whose sign readers of integers lose), with an exponent of each
/// kind. What JSON has no number for is a string, in one way.
[[nodiscard]] std::vector<std::string> spellings_of(double number);

}  // namespace carom::subjects::protocol
