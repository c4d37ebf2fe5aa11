// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstdint>
#include <ostream>
#include <span>
#include <string_view>
#include <vector>

#include <carom/collision/subject.hpp>

namespace carom::mutants {

/// A right solver that takes nearly special values for special ones.
struct Shortcut {
  std::string_view name;  // of the near feature, without "near_"
  Law law;
  std::string_view sentence;  // what the solver does; t is the threshold
  /// Changes a collision as the solver reads it. The threshold is a relative distance.
  void (*read)(Collision&, double threshold);
};

inline void PrintTo(const Shortcut& shortcut, std::ostream* out) { *out << shortcut.name; }

[[nodiscard]] std::span<const Shortcut> all_shortcuts();

/// A threshold for each shortcut, from 10⁻³ to 10⁻¹². Their logarithms are uniform.
[[nodiscard]] std::vector<double> drawn_thresholds(std::uint64_t seed);

/// The built-in solver of the law, which gets the collision as read. The change of the velocities is that of the
/// collision as read.
[[nodiscard]] Subject subject_of(const Shortcut& shortcut, double threshold);

/// The cases of a default run with this seed that reject each shortcut, of which at most `most` are counted. A case
/// rejects a shortcut if its answer differs from that of the built-in solver and violates an invariant of one outcome.
/// So a gate, which judges relations too, rejects at least these. The run ends once all but `most_missed` shortcuts
/// have `most` cases.
[[nodiscard]] std::vector<std::uint64_t> rejecting_cases(std::span<const double> thresholds, std::uint64_t seed,
                                                         std::uint64_t most, std::size_t most_missed = 0);

}  // namespace carom::mutants
