// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/properties/plan/plan.hpp>

namespace carom::tool::plan {

/// Times built-in methods by Google Benchmark. Each time is the median of `repetitions` repetitions in random order. If
/// there are fewer contacts than `contacts_timed`, the contacts are repeated. The clock throws std::logic_error if a
/// candidate is not a built-in method. Precondition: repetitions > 0.
[[nodiscard]] properties::plan::Clock clock_of(int repetitions);

}  // namespace carom::tool::plan
