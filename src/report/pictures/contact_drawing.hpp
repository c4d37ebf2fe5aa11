// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <optional>
#include <string>

#include <pugixml.hpp>

#include <carom/collision/outcome.hpp>

namespace carom::report {

/// The velocities in a picture of a contact.
struct Motion {
  Outcome<double> outcome;
  Vector3<double> relative_velocity;  // of the contact point, V = V_A − V_B
};

struct ContactPicture {
  const Collision& collision;
  Motion before;
  std::optional<Motion> computed;  // none if the subject gave no finite numbers
  std::optional<Motion> exact;     // none if the law determines no outcome
};

/// Appends a figure with two drawings: the bodies with their velocities, and the relative velocity of
/// the contact point. `name` is unique in its page. `title` names the contact. Precondition: the collision is valid.
/// Its numbers may be of any size.
void add_contact_figure(pugi::xml_node parent, const ContactPicture& picture, const std::string& name,
                        const std::string& title);

}  // namespace carom::report
