// SPDX-License-Identifier: BSL-1.0
#include <carom/impulse/numbers/double_double.hpp>
#include <carom/subjects/methods/method_groups.hpp>
#include <carom/subjects/methods/scalar_methods.hpp>

namespace carom::subjects {

// The outcome is rounded to long double, with an error of at most half a unit in the last place of `extended`.
std::vector<Method> double_double_methods() { return law_methods<impulse::DoubleDouble>(); }

}  // namespace carom::subjects
