// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include <carom/collision/model.hpp>
#include <carom/properties/plan/classed_collision.hpp>

namespace carom::tool::plan {

/// What a plan is made for.
struct RecordedContacts {
  std::vector<properties::plan::ClassedCollision> contacts;
  std::optional<Model> law;  // of a scene
};

/// A scene has as many impacts as it takes; a plan is certified on so many of them, at equal distances.
inline constexpr std::size_t most_contacts_of_scene = 10'000;

/// The contacts that a file holds: collisions as `replay` reads them, each with an optional class; or the impacts of a
/// scene, which is run for that, with the bodies and their materials as classes. One whose ε, μ or e_t alone is out of
/// range is kept. Throws UsageError that names the file, the place in it, the field, and what was expected; or says
/// that the user stopped it.
[[nodiscard]] RecordedContacts contacts_of_file(const std::string& file, const std::stop_token& stop);

}  // namespace carom::tool::plan
