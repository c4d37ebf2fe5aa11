// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/collision/law.hpp>

#include "input.hpp"

namespace carom::fuzz {

/// Puts a case to one of the built-in sound solvers of the law in double, and judges the answer on every invariant of
/// the law. The first byte selects the solver; the case follows. A violation is a finding, printed as a witness that
/// `carom replay` reads. Beyond the claimed domain (claimed_domain.hpp) only two findings exist: a refusal, and a
/// second answer to the same case that differs from the first.
void judge_law(Bytes bytes, Law law);

}  // namespace carom::fuzz
