// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/properties/features/feature.hpp>

namespace carom::properties {

/// A collision with magnitudes from all decades of the features, and with some special values and relations. It
/// collides if possible.
[[nodiscard]] Collision structured_collision(Stream& stream);

/// Gives one collision in four a few special values and relations. An approaching collision stays approaching.
void sprinkle(Stream& stream, Collision& collision);

/// Makes both features in turn, again if one undoes the other, at most four times. Returns whether both are present.
bool make_both(Stream& stream, Collision& collision, const Feature& first, const Feature& second);

}  // namespace carom::properties
