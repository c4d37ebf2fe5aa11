// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <istream>
#include <ostream>

#include <carom/collision/subject.hpp>

namespace carom::subjects::protocol {

/// The subject's side of the protocol: answers requests with the subject until `stop` or the end of the input. Returns
/// the exit status for main: 0, or 2 after an unreadable request, which is reported on standard error. Precondition: a
/// subject with `shows_collision_matrix` forms a matrix for every contact that it changes.
[[nodiscard]] int serve(const Subject& subject, std::istream& input, std::ostream& output);

}  // namespace carom::subjects::protocol
