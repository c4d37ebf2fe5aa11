// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include <carom/collision/collision.hpp>

namespace carom::properties {

/// Simpler collisions close to this one, from the boldest change on: a body becomes immovable, a vector zero, a number
/// rounded to few bits. Each collision is valid and has a smaller `complexity`, so shrinking ends. Precondition: the
/// collision is valid.
[[nodiscard]] std::vector<Collision> simpler(const Collision& collision);

/// How hard a collision is to read: the bits of its numbers, and the distance of their exponents from 0.
[[nodiscard]] long complexity(const Collision& collision);

/// The simplest failing collision found. Ends if no collision of `simpler` fails, or after `most_calls` calls of
/// `still_fails`. Precondition: the collision is valid.
[[nodiscard]] Collision shrink(Collision collision, const std::function<bool(const Collision&)>& still_fails,
                               std::size_t most_calls);

}  // namespace carom::properties
