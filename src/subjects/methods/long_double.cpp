// SPDX-License-Identifier: BSL-1.0
#include <carom/subjects/methods/method_groups.hpp>
#include <carom/subjects/methods/scalar_methods.hpp>

namespace carom::subjects {

std::vector<Method> long_double_methods() { return scalar_methods<long double>(); }

}  // namespace carom::subjects
