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
  /// Both movable bodies are convex with uniform density and the contact lies in both, so that C ⪯ 16 λI.
  bool convex_uniform = false;
  /// The changes that the family made after it drew the numbers.
  PerAdjustment<bool> adjusted = {};
};

/// The quantity that is large in a family beyond the claimed domain.
struct MeasuredQuantity {
  std::string_view name;  // "κ(K), at most"
  double (*of)(const Collision&) = nullptr;
};

/// The turn of a family without a rank.
inline constexpr int last_turn = 1000;

/// A named distribution of random collisions, and its properties.
struct Family {
  std::string_view name;
  std::string_view summary;
  Case (*generate)(Stream&);
  /// The families take turns in this order. A family of rank 1 to 10 found the most planted defects (tests/mutants)
  /// that the families before it had missed. Only its first two cases of eight seeds counted. The other families found
  /// no defect that these had missed. Their order is the number of defects that each finds alone; the last two are in
  /// the order in which they were added. `first_violation --families` (tests/benchmarks) computes the ranks.
  int turn = last_turn;
  int weight = 1;        // factor of the number of cases that the gate draws
  bool is_valid = true;  // false if a subject must refuse each of its collisions
  /// For a family beyond the domain that solvers claim. The least value at which a subject violates an invariant is the
  /// limit of that subject. Such a family decides no verdict unless the user names it.
  MeasuredQuantity beyond = {};

  [[nodiscard]] bool is_beyond_domain() const { return beyond.of != nullptr; }
};

/// Every family of the claimed domain, in the order of the reports.
[[nodiscard]] std::span<const Family> all_families();

/// Every family beyond the claimed domain.
[[nodiscard]] std::span<const Family> families_beyond_domain();

/// The family of this name, of either kind; nullptr if there is none.
[[nodiscard]] const Family* family_named(std::string_view name);

/// The family's case with this number, from 0. It depends only on the seed, the family's name and the number.
[[nodiscard]] Case drawn_case(const Family& family, std::uint64_t seed, std::uint64_t index);

}  // namespace carom::properties
