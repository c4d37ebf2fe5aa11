// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <vector>

#include <carom/subjects/methods.hpp>

/// The methods by the unit that compiles them.
namespace carom::subjects {

[[nodiscard]] std::vector<Method> float_methods();
[[nodiscard]] std::vector<Method> double_methods();
[[nodiscard]] std::vector<Method> long_double_methods();
[[nodiscard]] std::vector<Method> double_double_methods();

/// Reflection by Eigen's decompositions that pivot.
[[nodiscard]] std::vector<Method> pivoting_float_methods();
[[nodiscard]] std::vector<Method> pivoting_double_methods();

/// Solved in float, refined once in double.
[[nodiscard]] std::vector<Method> refined_methods();

/// Never penetrating, exactly.
[[nodiscard]] std::vector<Method> guaranteed_methods();

/// Many contacts at once, in packs.
[[nodiscard]] std::vector<Method> batch_methods();

}  // namespace carom::subjects
