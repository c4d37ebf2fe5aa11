// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>
#include <vector>

#include <carom/collision/subject.hpp>
#include <carom/properties/domains/domain.hpp>

namespace carom::tool {

/// The domain that the command line's `option` names: a text of `properties::domain_from`, or a JSON file of ranges.
/// Throws UsageError.
[[nodiscard]] properties::Domain domain_from_argument(const std::string& option, const std::string& text);

/// The domain that the subjects declare. A subject that declares none is meant for everything. Throws UsageError if two
/// subjects differ, or if a domain is not valid.
[[nodiscard]] properties::Domain declared_domain(const std::vector<Subject>& subjects);

}  // namespace carom::tool
