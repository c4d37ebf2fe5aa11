// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include <carom/collision/collision.hpp>
#include <carom/properties/draws/adjustment.hpp>
#include <carom/properties/draws/stream.hpp>

namespace carom::properties {

/// A collision, and the facts that its family knows about it.
struct Case {
  Collision collision;
  /// Each movable body is convex with uniform density, and the contact lies in or on it. Then C ⪯ 16 λI, with C the
  /// collision matrix and λ = 1/m_A + 1/m_B.
  bool convex_uniform = false;
  /// The changes that the family made after it drew the numbers.
  PerAdjustment<bool> adjusted = {};
};

/// The quantity that a family takes beyond the domain that solvers claim.
struct MeasuredQuantity {
  std::string_view name;  // "upper bound of κ(K)"
  double (*of)(const Collision&) = nullptr;
};

/// The turn of each family beyond the claimed domain: after all others.
inline constexpr int last_turn = 1000;

/// A named distribution of random collisions, and its properties.
struct Family {
  std::string_view name;
  std::string_view summary;
  Case (*generate)(Stream&);
  /// The place of the family in a run, from 1: families take turns in this order (gate/schedule.hpp), so that the first
  /// cases find most defects. `first_violation --families` (tests/benchmarks) ranks the families by the planted defects
  /// (tests/mutants) that their first two cases find, for eight seeds. Families 1 to 10 are chosen greedily: each finds
  /// the most defects that those before it miss. The ten together miss no defect that another family finds. The other
  /// families follow by the number of defects that each finds alone, except the last two, which are not ranked.
  int turn = last_turn;
  int weight = 1;        // factor of the number of cases that the gate draws
  bool is_valid = true;  // false if a subject must refuse each of its collisions
  /// For a family beyond the domain that solvers claim. The limit of a subject (a solver under test) is the least value
  /// of this quantity at which it violates an invariant. The family decides no verdict unless the user names it.
  MeasuredQuantity beyond = {};

  [[nodiscard]] bool is_beyond_domain() const { return beyond.of != nullptr; }
};

/// Every family of the claimed domain, in the order of the reports.
[[nodiscard]] std::span<const Family> all_families();

/// Every family beyond the claimed domain.
[[nodiscard]] std::span<const Family> families_beyond_domain();

/// The family of this name, within the claimed domain or beyond it; nullptr if there is none.
[[nodiscard]] const Family* family_named(std::string_view name);

/// The family's case with the number `index`, from 0. The case depends only on the seed, the family's name and the
/// number.
[[nodiscard]] Case drawn_case(const Family& family, std::uint64_t seed, std::uint64_t index);

}  // namespace carom::properties
