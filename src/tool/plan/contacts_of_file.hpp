// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <functional>
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

/// Runs the scene that a text describes: its impacts. The name of its file is for messages.
using ContactsOfScene =
    std::function<RecordedContacts(const std::string& text, const std::string& file, const std::stop_token& stop)>;

/// The contacts that a file holds: collisions as `replay` reads them, each with an optional class; or the impacts of a
/// scene, if `contacts_of_scene` is set. A collision of which only ε, μ or e_t is out of range is kept. Throws
/// UsageError that names the file, the place in it, the field, and what was expected; or that the user stopped it.
[[nodiscard]] RecordedContacts contacts_of_file(const std::string& file, const ContactsOfScene& contacts_of_scene,
                                                const std::stop_token& stop);

}  // namespace carom::tool::plan
