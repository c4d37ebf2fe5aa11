// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include <carom/properties/widest_domain/widest_domain.hpp>

/// Every form of a measured domain.
namespace carom::report {

struct MeasuredDomain {
  std::string subject;
  std::vector<std::string> deviates;  // deviations from the command line
  properties::WidestDomainOptions options;
  properties::WidestDomain reach;
  DeclaredEffects effects = {};  // of the subject

  /// Whether the subject could be judged in the core, and holds there.
  [[nodiscard]] bool is_known() const { return reach.ends.error.empty() && !reach.ends.in_core; }
};

/// The measured domain as docs/reference/schemas/domain.schema.json describes it.
[[nodiscard]] nlohmann::json reach_record(const MeasuredDomain& measured);

/// The measured domain for a terminal.
[[nodiscard]] std::string reach_text(const MeasuredDomain& measured);

/// One bar for each quantity, with the range of another domain beside it, as SVG. Precondition: the domain is known.
[[nodiscard]] std::string reach_svg(const MeasuredDomain& measured, const properties::Domain& beside,
                                    const std::string& name_of_beside);

}  // namespace carom::report
