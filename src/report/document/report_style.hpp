// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string_view>

namespace carom::report {

/// The style sheet of report.html. HTML does not unescape the content of <style>, so the style sheet must not contain
/// <, > or &.
extern const std::string_view report_style;

}  // namespace carom::report
