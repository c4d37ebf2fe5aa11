// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/collision/collision.hpp>
#include <carom/properties/draws/vectors.hpp>

namespace carom::properties {

/// The greatest principal moment of a body over its least; 0 if the body is immovable.
[[nodiscard]] inline double moment_ratio(const Body& body) {
  return body.immovable ? 0 : greatest(body.principal_inertia) / least(body.principal_inertia);
}

}  // namespace carom::properties
