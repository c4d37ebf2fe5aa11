// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string_view>

namespace carom::report {

/// The style sheet of report.html. It must not contain <, > or &, because HTML does not unescape the content of
/// <style>.
extern const std::string_view report_style;

}  // namespace carom::report
