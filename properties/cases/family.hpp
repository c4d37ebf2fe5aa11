// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include <carom/collision/collision.hpp>
#include <carom/properties/cases/domain.hpp>
#include <carom/properties/draws/stream.hpp>

namespace carom::properties {

struct Case {
  Collision collision;
  /// Whether each movable body is convex and uniform, with the contact inside or on its surface. If so, C ⪯ 16 λI, with
  /// the collision matrix C and λ = 1/m_A + 1/m_B.
  bool convex_uniform = false;
  PerAdjustment<bool> adjusted = {};
};

/// A quantity that a family takes beyond the domain that solvers claim.
struct MeasuredQuantity {
  std::string_view name;  // "upper bound of κ(K)"
  double (*of)(const Collision&) = nullptr;
};

/// The turn of each family beyond the claimed domain: after all others.
inline constexpr int last_turn = 1000;

/// A named distribution of random collisions.
struct Family {
  std::string_view name;
  std::string_view summary;
  Case (*generate)(Stream&);
  /// The place of the family in the gate's order of turns, from 1 (gate/task.hpp). The order is by the planted
  /// defects (tests/mutants) that the first two cases of a family find. Each of families 1 to 10 finds the most of the
  /// defects that the families before it miss.
  int turn = last_turn;
  int weight = 1;        // factor of the number of cases that the gate draws
  bool is_valid = true;  // false if a subject must refuse its collisions
  /// Set for a family beyond the claimed domain. A subject's limit is the least quantity at which the subject violates
  /// an invariant. The family decides no verdict unless the user names it.
  MeasuredQuantity beyond = {};
  /// The coefficient that makes the family what it is. A domain that excludes it has no case of the family.
  std::optional<LimitedQuantity> keeps = {};
  /// Whether a collision is still one of the family after it was put into the kinds of a domain. nullptr: any is. Kinds
  /// in which none is have no case of the family.
  bool (*is_still)(const Collision&) = nullptr;

  [[nodiscard]] bool is_beyond_domain() const { return beyond.of != nullptr; }
};

/// Every family of the claimed domain, in the order of the reports.
[[nodiscard]] std::span<const Family> all_families();

[[nodiscard]] std::span<const Family> families_beyond_domain();

[[nodiscard]] std::vector<const Family*> pointers_to(std::span<const Family> families);

/// In the claimed domain or beyond it; nullptr if no family has this name.
[[nodiscard]] const Family* family_named(std::string_view name);

/// The family's case with the number `index`, from 0. It depends only on the seed, the family's name and the number.
[[nodiscard]] Case drawn_case(const Family& family, std::uint64_t seed, std::uint64_t index);

/// A case of a random family of valid collisions. The probability of a family is proportional to its weight.
[[nodiscard]] Case case_of_any_family(Stream& stream);

}  // namespace carom::properties
