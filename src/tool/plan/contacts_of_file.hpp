// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include <carom/properties/plan/classed_collision.hpp>

namespace carom::tool::plan {

/// The contacts that a file holds: collisions as `replay` reads them, each with an optional class. One whose ε, μ or
/// e_t alone is out of range is kept. Throws UsageError that names the file, the place in it, the field, and what was
/// expected.
[[nodiscard]] std::vector<properties::plan::ClassedCollision> contacts_of_file(const std::string& file);

}  // namespace carom::tool::plan
