// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/properties/families/family.hpp>

namespace carom::properties {

/// A collision of `general_bodies` with one invalid field. Either a random number is not finite, or a random field is
/// outside its range.
[[nodiscard]] Case invalid(Stream& stream);

}  // namespace carom::properties
