// SPDX-License-Identifier: BSL-1.0
#include <carom/subjects/engines.hpp>
#include <carom/subjects/engines/claims.hpp>

namespace carom::subjects {

std::vector<Subject> ode_subjects() { return absent(ode_claims(), "libode-dev"); }

}  // namespace carom::subjects
