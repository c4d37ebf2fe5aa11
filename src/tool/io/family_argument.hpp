// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>

#include <carom/properties/families/family.hpp>

namespace carom::tool {

/// The family that the command line names by this option. Throws UsageError, which names those there are, where there
/// is none.
[[nodiscard]] const properties::Family& family_from_argument(const std::string& option, const std::string& name);

}  // namespace carom::tool
