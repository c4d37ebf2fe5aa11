// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/properties/cases/family.hpp>

namespace carom::properties {

/// `general_bodies` with one invalid field: a random number is not finite, or a random field is out of range.
[[nodiscard]] Case invalid(Stream& stream);

}  // namespace carom::properties
