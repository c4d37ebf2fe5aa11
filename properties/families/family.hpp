// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include <carom/collision/collision.hpp>
#include <carom/properties/draws/adjustment.hpp>
#include <carom/properties/draws/stream.hpp>

namespace carom::properties {

/// A collision, and what its family knows of it.
struct Case {
  Collision collision;
  /// Both movable bodies are convex with uniform density and the contact lies in both, so that C ⪯ 16 λI.
  bool convex_uniform = false;
  /// What the family changed after it drew the numbers.
  PerAdjustment<bool> adjusted = {};
};

/// What a family beyond the claimed domain has much of.
struct MeasuredQuantity {
  std::string_view name;  // "κ(K), at most"
  double (*of)(const Collision&) = nullptr;
};

/// The turn of a family that nobody has ranked.
inline constexpr int last_turn = 1000;

/// A named distribution of collisions, and all that is known of it.
struct Family {
  std::string_view name;
  std::string_view summary;
  Case (*generate)(Stream&);
  /// In a run the families take turns in this order. Each of the first ten found most of the planted defects
  /// (tests/mutants) that those before it had left, by its first two cases of eight seeds. The others found none of
  /// these. They stand by how many they find alone, the last two by when they came.
  /// `first_violation --families` (tests/benchmarks) counts them anew.
  int turn = last_turn;
  int weight = 1;        // the gate draws so many times as many cases of it
  bool is_valid = true;  // false if each of its collisions is to be refused
  /// Of a family beyond the domain that solvers claim. The least of it at which a subject violates something is where
  /// that subject stops. Such a family decides no verdict unless it is asked for by its name.
  MeasuredQuantity beyond = {};

  [[nodiscard]] bool is_beyond_domain() const { return beyond.of != nullptr; }
};

/// Every family of the claimed domain, in the order of the design.
[[nodiscard]] std::span<const Family> all_families();

/// Every family beyond it.
[[nodiscard]] std::span<const Family> families_beyond_domain();

/// The family of this name, of either kind; nullptr if there is none.
[[nodiscard]] const Family* family_named(std::string_view name);

/// The family's case of this number, from 0: of a seed always the same.
[[nodiscard]] Case drawn_case(const Family& family, std::uint64_t seed, std::uint64_t index);

}  // namespace carom::properties
