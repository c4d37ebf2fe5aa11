// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <span>
#include <vector>

#include <carom/collision/subject.hpp>

namespace carom::properties {

/// The answers of a session, one for each collision. Throws std::runtime_error if the session gives more or fewer.
[[nodiscard]] std::vector<Answer> answers_of(Session& session, std::span<const Collision> collisions);

}  // namespace carom::properties
