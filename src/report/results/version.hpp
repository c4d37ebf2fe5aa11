// SPDX-License-Identifier: BSL-1.0
#pragma once

namespace carom::report {

/// The version of Carom: "0.1.0".
extern const char* const version;

}  // namespace carom::report
