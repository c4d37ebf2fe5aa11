// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/properties/families/family.hpp>

namespace carom::properties {

/// A general collision with one field made invalid: each number in turn not finite, and each field that has a range
/// outside of it.
[[nodiscard]] Case invalid(Stream& stream);

}  // namespace carom::properties
