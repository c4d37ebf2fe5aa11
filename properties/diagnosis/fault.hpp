// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <span>
#include <string>

#include <carom/properties/diagnosis/known_case.hpp>

namespace carom::properties::diagnosis {

/// What is wrong, and where one looks first.
struct Fault {
  std::string what;
  std::string look_at;
};

/// At which step most of the outcomes leave mechanics: what happens without a cause, the reaction, the spins, the
/// impulse itself. Each outcome is told apart by the first step that it fails.
/// Precondition: there is a case; the answers are outcomes of finite numbers to valid collisions.
[[nodiscard]] Fault fault_of(std::span<const ViolatedCase> cases, Law law);

}  // namespace carom::properties::diagnosis
