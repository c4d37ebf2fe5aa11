// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include <carom/collision/collision.hpp>

namespace carom::properties {

/// Simpler collisions close to this one, the boldest simplifications first: a body made immovable, a vector set to
/// zero, a number rounded to few bits. Each is valid and strictly simpler by `complexity`, so that shrinking ends, in
/// small dyadic numbers. Precondition: the collision is valid.
[[nodiscard]] std::vector<Collision> simpler(const Collision& collision);

/// How hard a collision is to read: the bits of its numbers and the distance of their exponents from 0.
[[nodiscard]] long complexity(const Collision& collision);

/// The collision that no further step of `simpler` keeps failing, from one that fails. `still_fails` is called at most
/// `most_calls` times.
[[nodiscard]] Collision shrink(Collision collision, const std::function<bool(const Collision&)>& still_fails,
                               std::size_t most_calls);

}  // namespace carom::properties
