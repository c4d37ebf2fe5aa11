// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include <carom/collision/collision.hpp>

namespace carom::properties {

/// Simpler collisions close to this one, the boldest simplifications first: a body becomes immovable, a vector zero, a
/// number rounded to few bits. Each is valid and has a smaller `complexity`, so shrinking ends. It ends with numbers of
/// few binary digits. Precondition: the collision is valid.
[[nodiscard]] std::vector<Collision> simpler(const Collision& collision);

/// A measure of how hard a collision is to read: the bits of its numbers, and the distance of their exponents from 0.
[[nodiscard]] long complexity(const Collision& collision);

/// Simplifies a failing collision until no step of `simpler` still fails, or until `most_calls` calls of `still_fails`.
/// Returns the simplest failing collision found. Precondition: the collision is valid.
[[nodiscard]] Collision shrink(Collision collision, const std::function<bool(const Collision&)>& still_fails,
                               std::size_t most_calls);

}  // namespace carom::properties
