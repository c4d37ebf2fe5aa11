// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/properties/families/family.hpp>

namespace carom::properties {

/// A general collision with one invalid field: a random number is not finite, or a random field with a range is outside
/// of it.
[[nodiscard]] Case invalid(Stream& stream);

}  // namespace carom::properties
