// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/properties/features/feature.hpp>

/// Gives collisions features: special values, relations and magnitudes (feature.hpp).
namespace carom::properties {

/// A collision whose magnitudes are drawn from all decades that the features list. It also has some special values and
/// relations. It collides if the drawn features allow it.
[[nodiscard]] Collision structured_collision(Stream& stream);

/// Gives one collision in four a few special values and relations. An approaching collision stays approaching.
void sprinkle(Stream& stream, Collision& collision);

/// Makes both features in turn, and again if one undoes the other, at most four times. Returns whether both are present
/// at the end.
bool make_both(Stream& stream, Collision& collision, const Feature& first, const Feature& second);

}  // namespace carom::properties
