// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <carom/collision/collision.hpp>

/// A spelling is one of several ways to write the same collision, which docs/reference/protocol.md permits. The order
/// of fields, blanks between tokens, forms of numbers (2, 2.0 or 2e0), and fields with default values are free.
namespace carom::subjects::protocol {

/// The number of spellings of each collision. Spelling 0 has the order of the protocol's example, no defaults, and the
/// shortest numbers. The collision's bits determine the other spellings.
inline constexpr unsigned spelling_count = 4;

/// The collision as one JSON object. A reader that rounds decimals to the nearest binary64 number reads the same bits
/// from every spelling. Precondition: spelling < spelling_count.
[[nodiscard]] std::string spelt(const Collision& collision, unsigned spelling);

/// A hash of the collision's bits.
[[nodiscard]] std::uint64_t hash_of(const Collision& collision);

/// The spellings of a number, the shortest first. Only whole numbers below 2⁵³ are spelt as integers; −0 is not,
/// because readers of integers lose its sign. NaN and infinities have one spelling, a string.
[[nodiscard]] std::vector<std::string> spellings_of(double number);

}  // namespace carom::subjects::protocol
