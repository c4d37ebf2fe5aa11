// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include <carom/properties/gate/answered_kinds.hpp>
#include <carom/properties/gate/gate_report.hpp>

namespace carom::properties {

/// Proposes domains in which no known case of a subject violates an invariant. A proposal adds at most two conditions
/// to the domain of the run: one end of a quantity's range, or a trait. The proposals with one condition come first,
/// then those with the larger share of the cases.
class DomainProposals {
 public:
  DomainProposals(const SubjectResult& result, const GateReport& report);

  /// None if no proposal is left.
  [[nodiscard]] std::optional<Domain> next();
  /// A violation that fresh cases showed in a proposal.
  void add_violation(const Collision& collision);

 private:
  static constexpr std::size_t ends = 2 * all_limited_quantities.size();

  /// A case, by what a domain can limit.
  struct Placed {
    /// For the upper end of each quantity the largest value, then for the lower ends the negative smallest value. A
    /// case is within an end if this number is at most the end's. −∞ if the case does not have the quantity.
    std::array<double, ends> at;
    std::uint32_t traits;  // as bits
  };
  /// Conditions, and the first values of their ends at which known cases are violated.
  struct Proposal {
    std::uint32_t traits = 0;
    std::vector<std::pair<std::size_t, double>> ends = {};
    std::size_t conditions = 0;
    double share = 0;      // of the cases that remain
    std::size_t rank = 0;  // the least is tried first
  };
  using Conditions = std::pair<std::uint32_t, std::vector<std::size_t>>;  // traits and ends

  [[nodiscard]] Placed placed(const Collision& collision) const;
  void add_ends_of(std::uint32_t traits, std::vector<Proposal>& all) const;
  void add_pairs_of_ends(std::vector<Proposal>& all) const;
  void add_traits(std::vector<Proposal>& all) const;
  void add_if_useful(Proposal proposal, std::size_t excluded, std::vector<Proposal>& all) const;
  [[nodiscard]] double share_of(const Proposal& proposal) const;
  [[nodiscard]] std::vector<Proposal> proposals() const;
  [[nodiscard]] std::optional<Domain> domain_of(const Proposal& proposal, std::size_t attempt) const;
  [[nodiscard]] bool holds_violation(const Domain& domain, std::uint32_t traits) const;

  Domain within_;
  std::vector<Trait> traits_;
  bool is_hopeless_ = false;  // no domain excludes a violation
  std::vector<Placed> violated_ = {};
  std::vector<Placed> generic_ = {};  // of the family `generic`
  std::vector<Placed> all_ = {};      // a sample of all families
  std::map<Conditions, std::size_t> attempts_ = {};
};

}  // namespace carom::properties
