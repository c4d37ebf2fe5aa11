// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/collision/collision.hpp>

#include "defect.hpp"

namespace carom::mutants {

/// The collision that a solver with this defect reads. Precondition: the collision is valid.
[[nodiscard]] Collision misread(Defect defect, const Collision& collision);

}  // namespace carom::mutants
