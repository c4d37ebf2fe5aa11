// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstdint>

#include <carom/collision/subject.hpp>

/// The solver under test, as functions of JavaScript. src/web/README.md lists them.
namespace carom::web {

/// Opens a session of JavaScript's solver for a subject with these claims. Each request and answer is a row of doubles.
/// A failed session throws SessionFailure.
[[nodiscard]] Session open_solver(const Subject& subject);

/// Tells JavaScript how many cases are judged.
void report_progress(std::uint64_t done, std::uint64_t all);

}  // namespace carom::web
