// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/properties/features/feature.hpp>

/// Collisions that are made to have features.
namespace carom::properties {

/// A collision whose magnitudes are drawn from all decades that the features list, and that has some special values and
/// relations besides; colliding, where the ones that were drawn allow it.
[[nodiscard]] Collision structured_collision(Stream& stream);

/// Gives the collision a few special values and relations, at times; it stays approaching where it is.
void sprinkle(Stream& stream, Collision& collision);

/// One after the other, and again what the later ones undid. True where both are present in the end.
bool make_both(Stream& stream, Collision& collision, const Feature& first, const Feature& second);

}  // namespace carom::properties
