// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>

#include <carom/properties/families/family.hpp>

namespace carom::tool {

/// The family that an option names. Throws UsageError that lists the known families if there is none.
[[nodiscard]] const properties::Family& family_from_argument(const std::string& option, const std::string& name);

}  // namespace carom::tool
