// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <vector>

#include <carom/subjects/methods.hpp>

/// The methods by the unit that compiles them.
namespace carom::subjects {

[[nodiscard]] std::vector<Method> float_methods();
[[nodiscard]] std::vector<Method> double_methods();
[[nodiscard]] std::vector<Method> long_double_methods();

}  // namespace carom::subjects
