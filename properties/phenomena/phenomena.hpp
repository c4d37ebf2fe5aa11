// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/properties/phenomena/phenomenon.hpp>

/// The phenomena, one file each. `all_phenomena` lists them.
namespace carom::properties {

[[nodiscard]] Phenomenon bounce();
[[nodiscard]] Phenomenon slow_bounce();
[[nodiscard]] Phenomenon slide();
[[nodiscard]] Phenomenon slide_to_roll();
[[nodiscard]] Phenomenon stick();
[[nodiscard]] Phenomenon spin();
[[nodiscard]] Phenomenon free_rotation();
[[nodiscard]] Phenomenon flat_landing();
[[nodiscard]] Phenomenon stack();
[[nodiscard]] Phenomenon pass_through();

}  // namespace carom::properties
