// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <optional>
#include <string>

#include <pugixml.hpp>

#include <carom/collision/outcome.hpp>

namespace carom::report {

/// What moves in a picture of a contact.
struct Motion {
  Outcome<double> outcome;
  Vector3<double> relative_velocity;  // of the contact point, V = V_A − V_B
};

struct ContactPicture {
  const Collision& collision;
  Motion before;
  std::optional<Motion> computed;  // none where the subject gave no finite numbers
  std::optional<Motion> exact;     // none where the model determines no outcome
};

/// Appends a figure of two drawings and their legend: the bodies and their velocities, and the relative velocity of
/// the contact point. `name` is unique in its page; `title` says whose contact it is. Precondition: the collision is
/// valid; its numbers may be as extreme as they come.
void add_contact_figure(pugi::xml_node parent, const ContactPicture& picture, const std::string& name,
                        const std::string& title);

/// Appends what the strokes mean.
void add_contact_legend(pugi::xml_node parent);

}  // namespace carom::report
