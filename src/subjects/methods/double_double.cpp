// SPDX-License-Identifier: BSL-1.0
#include <carom/impulse/numbers/double_double.hpp>
#include <carom/subjects/methods/method_groups.hpp>
#include <carom/subjects/methods/scalar_methods.hpp>

namespace carom::subjects {

// Rounding the outcome to long double costs at most half an ulp of `extended`.
std::vector<Method> double_double_methods() { return law_methods<impulse::DoubleDouble>(); }

}  // namespace carom::subjects
