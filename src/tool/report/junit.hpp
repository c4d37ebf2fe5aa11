// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>

#include "report/records.hpp"

namespace carom::tool {

/// The run as JUnit XML: a suite a subject, a case an invariant. Violations of subjects that do not count are reported
/// as skipped, so that CI shows them without failing.
[[nodiscard]] std::string junit_xml(const GateRun& run);

}  // namespace carom::tool
