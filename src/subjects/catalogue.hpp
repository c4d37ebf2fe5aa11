// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include <carom/collision/subject.hpp>
#include <carom/subjects/protocol/exec.hpp>

namespace carom::subjects {

/// The subjects of `methods()`: the solvers of carom/impulse, as users compile them.
[[nodiscard]] std::vector<Subject> built_in_subjects();

/// The built-in solvers, and the engines that are linked: what runs in this process, also what is not installed.
[[nodiscard]] std::vector<Subject> all_subjects();

/// Every engine, linked or over the protocol, also those not installed. Programs are started with these options.
[[nodiscard]] std::vector<Subject> engine_subjects(const protocol::ExecOptions& options);

/// The subject that this program knows by that name, engines over the protocol among them.
[[nodiscard]] std::optional<Subject> subject_named(std::string_view name, const protocol::ExecOptions& options = {});

/// What subject_named knows, with nothing started: engines over the protocol have no `open`.
[[nodiscard]] std::vector<Subject> known_subjects();

}  // namespace carom::subjects
