// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/properties/features/feature.hpp>

namespace carom::properties {

/// A collision with masses, sizes and speeds of random decades, and with some special values and relations. It collides
/// if possible.
[[nodiscard]] Collision structured_collision(Stream& stream);

/// Gives one collision in four a few special values and relations. If the bodies approach, they still approach
/// afterwards.
void sprinkle(Stream& stream, Collision& collision);

/// Makes several near features, of which one may undo another. The collision stays in the domain, and its bodies still
/// approach if they do.
void make_several_near(Stream& stream, Collision& collision);

/// Makes each feature that is absent. Repeats this, at most four times, because one may undo the other. Returns whether
/// both are present.
bool make_both(Stream& stream, Collision& collision, const Feature& first, const Feature& second);

}  // namespace carom::properties
