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

/// The built-in solvers and the linked engines, including absent engines.
[[nodiscard]] std::vector<Subject> all_subjects();

/// The gate judges these if no subject is named: the recommended solver of each law in binary64, the note's own method,
/// and the linked engines, including absent ones.
[[nodiscard]] std::vector<Subject> default_subjects();

/// Every engine, linked or over the protocol, including absent ones. Starts programs with `options`.
[[nodiscard]] std::vector<Subject> engine_subjects(const protocol::ExecOptions& options);

/// The subject with this name, including engines over the protocol; empty if there is none.
[[nodiscard]] std::optional<Subject> subject_named(std::string_view name, const protocol::ExecOptions& options = {});

/// The subjects that subject_named knows. Starts no program, so engines over the protocol have no `open`.
[[nodiscard]] std::vector<Subject> known_subjects();

}  // namespace carom::subjects
