// SPDX-License-Identifier: BSL-1.0
#include <carom/subjects/methods/method_groups.hpp>
#include <carom/subjects/methods/pivoting_methods.hpp>

namespace carom::subjects {

std::vector<Method> pivoting_double_methods() { return pivoting_methods<double>(); }

}  // namespace carom::subjects
