// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/collision/law.hpp>

#include "input.hpp"

namespace carom::fuzz {

/// Gives a case to a sound built-in solver of the law in double, and judges the answer on every invariant of the law.
/// The first byte selects the solver; the case follows. The target prints a violation as a witness that `carom replay`
/// reads. Beyond the claimed domain (law.cpp), a violation is no finding, but a refusal or two different
/// answers to one case are findings.
void judge_law(Bytes bytes, Law law);

}  // namespace carom::fuzz
