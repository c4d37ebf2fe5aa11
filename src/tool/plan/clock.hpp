// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/properties/plan/plan.hpp>

namespace carom::tool::plan {

/// Measures built-in methods by Google Benchmark: so many repetitions of all in a random order, and of each the median.
/// Where there are fewer contacts than `contacts_timed`, they are solved over again. The clock throws std::logic_error
/// where a candidate is no built-in method. Precondition: repetitions > 0.
[[nodiscard]] properties::plan::Clock clock_of(int repetitions);

}  // namespace carom::tool::plan
