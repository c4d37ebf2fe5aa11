// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <stop_token>
#include <string>

#include "commands/contacts_of_file.hpp"

namespace carom::tool::plan {

/// A plan is certified on fewer than twice this number of impacts of a scene. If a scene has more impacts, only every
/// n-th impact is used.
inline constexpr std::size_t most_contacts_of_scene = 10'000;

/// Runs the scene. Returns its law, and its impacts, classed by bodies and materials. Throws UsageError like
/// contacts_of_file.
[[nodiscard]] RecordedContacts contacts_of_scene(const std::string& text, const std::string& file,
                                                 const std::stop_token& stop);

}  // namespace carom::tool::plan
