// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/collision/subject.hpp>

#include "input.hpp"

namespace carom::fuzz {

/// A subject that answers as the input says: the rounded truth moved by some ulps, an outcome at the edge of the
/// allowance, any twelve numbers, a refusal or a skip. It reports the exact collision matrix with one changed entry.
/// It refers to the input, and each answer reads more of it.
[[nodiscard]] Subject made_up_subject(Input& input);

}  // namespace carom::fuzz
