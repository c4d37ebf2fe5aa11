// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string_view>

namespace carom::report {

/// The style sheet of report.html. It stands in an element whose text HTML takes as it is, and must therefore do
/// without <, > and &.
extern const std::string_view report_style;

}  // namespace carom::report
