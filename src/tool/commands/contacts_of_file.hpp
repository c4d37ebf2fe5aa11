// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include <carom/collision/law.hpp>
#include <carom/properties/plan/classed_collision.hpp>

namespace carom::tool::plan {

struct RecordedContacts {
  std::vector<properties::plan::ClassedCollision> contacts;
  std::optional<Law> law;  // of a scene
};

/// Runs the scene in a text and returns its impacts. `file` is for messages.
using ContactsOfScene =
    std::function<RecordedContacts(const std::string& text, const std::string& file, const std::stop_token& stop)>;

/// The contacts of a file: the collisions that for_each_collision reads, or the impacts of a scene if
/// `contacts_of_scene` is set. A collision is kept if its only defects are ε, μ or e_t out of range. Throws UsageError
/// that names the file, the place, the field, and what was expected. Throws UsageError, too, if the user stopped.
[[nodiscard]] RecordedContacts contacts_of_file(const std::string& file, const ContactsOfScene& contacts_of_scene,
                                                const std::stop_token& stop);

}  // namespace carom::tool::plan
