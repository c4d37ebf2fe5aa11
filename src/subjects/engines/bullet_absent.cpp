// SPDX-License-Identifier: BSL-1.0
#include <carom/subjects/engines.hpp>
#include <carom/subjects/engines/claims.hpp>

namespace carom::subjects {

std::vector<Subject> bullet_subjects() { return absent(bullet_claims(), "libbullet-dev"); }

}  // namespace carom::subjects
