// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <carom/properties/gate/gate_report.hpp>

namespace carom::properties {

/// A kind or a value of a coefficient: "plane=xy", "restitution=0".
struct Trait {
  std::string_view name;
  std::string text;
  Domain domain;
};

/// The traits that the domain leaves open.
[[nodiscard]] std::vector<Trait> traits_beside(const Domain& within);

/// The part of the domain that has the trait, which is one of `traits_beside`.
[[nodiscard]] Domain narrowed(const Domain& domain, const Trait& trait);

/// Says where a subject that skips more than a tenth of the cases answers, and the domain for `--within` that fits: "it
/// answered only contacts in the plane z = 0: add --within plane=xy". The answered ones of the sampled cases have a
/// kind or a coefficient in common that the skipped ones lack.
[[nodiscard]] std::string what_it_answers(const SubjectResult& result, const GateReport& report);

}  // namespace carom::properties
