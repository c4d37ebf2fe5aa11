// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/collision/law.hpp>

#include "input.hpp"

namespace carom::fuzz {

/// Gives a case to a built-in sound solver of the law in double, and judges the answer on every invariant of the law.
/// The first byte selects the solver; the case follows. A violation is printed as a witness that `carom replay` reads.
/// Beyond the claimed domain (claimed_domain.hpp) the only findings are a refusal, and two different answers to the
/// case.
void judge_law(Bytes bytes, Law law);

}  // namespace carom::fuzz
