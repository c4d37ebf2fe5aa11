// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/collision/subject.hpp>

#include "input.hpp"

namespace carom::fuzz {

/// A subject that answers what the input says: the truth as rounded and moved by so many ulps, an outcome at the edge
/// of what is allowed, any twelve numbers, a refusal or a skip. It shows a collision matrix that is the exact one but
/// for one number. It refers to the input, and reads on in it with each answer.
[[nodiscard]] Subject made_up_subject(Input& input);

}  // namespace carom::fuzz
