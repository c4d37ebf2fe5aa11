// SPDX-License-Identifier: BSL-1.0
#include "io/family_argument.hpp"

#include <vector>

#include <fmt/format.h>

#include <carom/properties/trial/nearest_name.hpp>

#include "io/usage_error.hpp"

namespace carom::tool {

const properties::Family& family_from_argument(const std::string& option, const std::string& name) {
  if (const properties::Family* family = properties::family_named(name)) {
    return *family;
  }
  std::vector<std::string> names;
  for (const auto kind : {properties::all_families(), properties::families_beyond_domain()}) {
    for (const properties::Family& known : kind) {
      names.emplace_back(known.name);
    }
  }
  throw UsageError(fmt::format("{}: there is no family '{}'; expected one of {}{}", option, name,
                               fmt::join(names, ", "), properties::did_you_mean(name, names)));
}

}  // namespace carom::tool
