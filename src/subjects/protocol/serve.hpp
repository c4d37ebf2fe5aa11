// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <istream>
#include <ostream>

#include <carom/collision/subject.hpp>
#include <carom/subjects/protocol/messages.hpp>

namespace carom::subjects::protocol {

/// The subject's side of the protocol: answers requests with the subject until `stop` or the end of the input. Returns
/// the exit status for main: 0, or 2 after an unreadable request, which is reported on standard error. If `numbers` is
/// `hex`, it asks for hexadecimal numbers. Each reply to `solve` has the form of its request. Precondition: a subject
/// with `shows_collision_matrix` forms a matrix for every contact that it changes.
[[nodiscard]] int serve(const Subject& subject, std::istream& input, std::ostream& output,
                        Numbers numbers = Numbers::decimal);

}  // namespace carom::subjects::protocol
