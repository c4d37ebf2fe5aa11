// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <stop_token>
#include <string>

#include "plan/contacts_of_file.hpp"

namespace carom::tool::plan {

/// A scene has as many impacts as it takes. A plan is certified on at most so many of them, at equal distances.
inline constexpr std::size_t most_contacts_of_scene = 10'000;

/// Runs the scene: its impacts, classed by bodies and materials, and its law. Throws UsageError as contacts_of_file
/// does.
[[nodiscard]] RecordedContacts contacts_of_scene(const std::string& text, const std::string& file,
                                                 const std::stop_token& stop);

}  // namespace carom::tool::plan
