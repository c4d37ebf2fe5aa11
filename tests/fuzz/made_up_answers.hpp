// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/collision/subject.hpp>

#include "input.hpp"

namespace carom::fuzz {

/// A subject whose answers come from the input. An answer is the rounded exact outcome moved by some ulps, an outcome
/// at the edge of the permitted rounding, any twelve numbers, a refusal or a skip. The subject reports the exact
/// collision matrix with one changed entry. Each answer reads more of the input, so the input must outlive the subject.
[[nodiscard]] Subject made_up_subject(Input& input);

}  // namespace carom::fuzz
