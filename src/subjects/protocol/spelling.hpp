// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <carom/collision/collision.hpp>

/// A spelling is one way to write a collision. docs/reference/protocol.md permits several: the order of fields, blanks
/// between tokens, and forms of numbers (2, 2.0 or 2e0) are free. Fields with default values may be omitted.
namespace carom::subjects::protocol {

/// The number of spellings of each collision. Spelling 0 has the order of the protocol's example, no fields with
/// default values, and the shortest numbers. A hash of the collision chooses the other spellings.
inline constexpr unsigned spelling_count = 4;

/// The collision as one JSON object. A reader that rounds decimals to the nearest binary64 number reads the same bits
/// from every spelling. Precondition: spelling < spelling_count.
[[nodiscard]] std::string spelt(const Collision& collision, unsigned spelling);

/// A hash of the collision's bits.
[[nodiscard]] std::uint64_t hash_of(const Collision& collision);

/// The spellings of a number, the shortest first. Only whole numbers below 2⁵³ are spelt as integers. −0 is not spelt
/// as an integer, because readers of integers lose its sign. NaN and infinities have one spelling, a string.
[[nodiscard]] std::vector<std::string> spellings_of(double number);

}  // namespace carom::subjects::protocol
