// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/properties/cases/domain.hpp>
#include <carom/report/results/archive.hpp>

namespace carom::report {

/// {"size": [0.1, 10], "mass_ratio": [null, 100]}: the least and the greatest value of each limited quantity, with null
/// for an end without a limit. `read` throws FormatError that names the place.
template <>
struct Json<properties::Domain> {
  static nlohmann::json write(const properties::Domain& domain);
  static properties::Domain read(const Field& field);
};

}  // namespace carom::report
