// SPDX-License-Identifier: BSL-1.0
#pragma once

namespace carom::report {

inline constexpr int exit_all_hold = 0;
inline constexpr int exit_violated = 1;
inline constexpr int exit_usage = 2;  // usage, environment, or input that cannot be read

}  // namespace carom::report
