// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/collision/model.hpp>

#include "input.hpp"

namespace carom::fuzz {

/// Puts a case to one of the built-in solvers of the law that compute in double and are sound, and judges the answer on
/// every invariant that the law claims. The first byte chooses the solver; the case follows. A violation is a finding,
/// printed as a witness that `carom replay` reads; but beyond the claimed domain only a refusal is one, or
/// an answer that changes when it is asked for again.
void judge_law(Bytes bytes, Model model);

}  // namespace carom::fuzz
