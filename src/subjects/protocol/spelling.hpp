// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <carom/collision/collision.hpp>

/// A spelling is one of several ways to write the same collision. docs/reference/protocol.md permits these. "JSON Lines
/// …, one object a line" leaves the order of fields and the blanks between JSON tokens free. "Numbers are JSON numbers
/// that round-trip binary64" permits 2, 2.0 and 2e0, or 0.0015, 1.5e-3 and 1.5E-03. A field with its default ("default
/// 1, 0, 0, 0", "default 0" or "default false") may be left out.
namespace carom::subjects::protocol {

/// The number of spellings of each collision. Spelling 0 is plain: it has the fields in the order of the protocol's
/// example, no defaults, and the shortest numbers. The other spellings are drawn from the collision's bits.
inline constexpr unsigned spelling_count = 4;

/// The collision as one JSON object. A reader that rounds decimals to the nearest binary64 number reads the same bits
/// from every spelling. Precondition: spelling < spelling_count.
[[nodiscard]] std::string spelt(const Collision& collision, unsigned spelling);

/// A hash of the collision's bits. Equal collisions have equal hashes, and few other collisions share them.
[[nodiscard]] std::uint64_t hash_of(const Collision& collision);

/// The spellings of a number, the shortest first: with a fraction, as an integer, and with an exponent of each kind.
/// Only whole numbers below 2⁵³ are spelt as integers, but not −0, because readers of integers lose its sign. NaN and
/// infinities, which JSON lacks, have one spelling, a string.
[[nodiscard]] std::vector<std::string> spellings_of(double number);

}  // namespace carom::subjects::protocol
