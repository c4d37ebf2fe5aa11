// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <vector>

#include <carom/subjects/methods.hpp>

/// Groups of methods that are compiled apart from methods.cpp.
namespace carom::subjects {

/// Methods that solve in float and refine once in double.
[[nodiscard]] std::vector<Method> refined_methods();

/// Methods whose exact N·V⁺ is never negative.
[[nodiscard]] std::vector<Method> guaranteed_methods();

[[nodiscard]] std::vector<Method> batch_methods();

}  // namespace carom::subjects
