// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <vector>

#include <carom/report/pictures/plot.hpp>
#include <carom/report/results/time_run.hpp>

/// The pictures of `carom time`.
namespace carom::report {

/// The error of a phenomenon against the steps of a second, and against the time that a second of the scene takes. A
/// line for each engine has its name at its end. An engine as shipped has no line beside its configured one. Errors
/// that rounding explains are left out. Empty if no engine has two points.
[[nodiscard]] std::vector<Plot> time_pictures(const properties::Phenomenon& phenomenon, const TimeRun& run);

/// The height of the first bounce with ε = 1/2 at `compared_step`: a bar for each engine, and a line at the known
/// height. Empty if no engine bounced.
[[nodiscard]] std::vector<Plot> first_bounce_picture(const TimeRun& run);

}  // namespace carom::report
