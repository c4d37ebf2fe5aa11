// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <span>

#include <carom/collision/collision.hpp>

#include "defect.hpp"

namespace carom::mutants {

/// The collision that a solver with these defects reads. Precondition: the collision is valid.
[[nodiscard]] Collision misread(std::span<const Defect> defects, const Collision& collision);

}  // namespace carom::mutants
