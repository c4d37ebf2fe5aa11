// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include <carom/collision/subject.hpp>

namespace carom::subjects {

/// The solvers of carom/impulse, as users compile them.
[[nodiscard]] std::vector<Subject> built_in_subjects();

/// Every subject that this program knows by name: the built-in solvers, then the engines, also those not installed.
[[nodiscard]] std::vector<Subject> all_subjects();

[[nodiscard]] std::optional<Subject> subject_named(std::string_view name);

}  // namespace carom::subjects
