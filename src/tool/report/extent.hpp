// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>

#include <carom/properties/gate/gate.hpp>

/// How much a run was to judge, and how much it did, in words.
namespace carom::tool {

/// "1000 cases of each of 26 families", "10 s on 26 families in turn"; and whether each subject's first violation ended
/// it.
[[nodiscard]] std::string extent_of(const properties::GateOptions& options);

/// Of a run with a budget: how many cases the subject was judged on, and of which family it was fewest. What "sound" is
/// said of. Precondition: there is a family.
[[nodiscard]] std::string cases_judged(const properties::SubjectResult& result, const properties::GateOptions& options);

}  // namespace carom::tool
