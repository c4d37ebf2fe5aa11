// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <optional>
#include <random>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <carom/collision/law.hpp>
#include <carom/properties/diagnosis/fault.hpp>

#include "drawn_solver.hpp"

namespace carom::mutants {

/// Numbers that are the same on every machine.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}

  [[nodiscard]] std::size_t below(std::size_t end) { return static_cast<std::size_t>(engine_() % end); }
  /// A number in [least, most), uniform or uniform in its logarithm, with three significant digits.
  [[nodiscard]] double between(double least, double most);
  [[nodiscard]] double log_between(double least, double most);
  /// A wrong factor: between 1/5 and 5, and at least 15 % away from 1.
  [[nodiscard]] double factor();
  template <class T>
  [[nodiscard]] T one_of(std::initializer_list<T> choices) {
    return *(choices.begin() + below(choices.size()));
  }

 private:
  std::mt19937_64 engine_;
};

/// A defect with drawn parameters, and what a description has to say to name it.
struct DrawnDefect {
  std::string_view kind = {};
  std::string words = {};  // "ε is multiplied by 0.437"
  /// Alternatives, separated by `|`. Of one of them, a description contains every part, and parts are separated by `&`.
  /// A part `!x` means that x is absent. `A` and `B` mean this body or both. `%x` means any word of a group
  /// (drawn_defects.cpp).
  std::string named_by = {};
  std::optional<double> limit = {};  // a number that the description states within a quarter
  Change change = {};
};

/// The bodies that a defect concerns.
struct Which {
  bool a;
  bool b;
  std::string_view words;  // "A", "B" or "both bodies"
  std::string_view part;   // of `named_by`: "A", "B" or both of them
};
[[nodiscard]] Which drawn_bodies(Random& random);
inline constexpr Which all_bodies{true, true, "", ""};
inline constexpr Which no_body{false, false, "", ""};

struct DefectKind {
  std::string_view name;
  std::span<const Law> laws;  // that have the defect
  DrawnDefect (*draw)(Random&);
};

/// ε is 0 if the approach is slower than the threshold [m/s].
[[nodiscard]] DrawnDefect restitution_threshold_at(double threshold);
/// The inertia of the bodies is taken along the world's axes.
[[nodiscard]] DrawnDefect orientation_ignored_in(const Which& which, unsigned uses);

/// Data and geometry that a solver reads or uses wrongly.
[[nodiscard]] std::span<const DefectKind> kinds_of_data();
/// Velocities, impulses, friction and limits that are wrong.
[[nodiscard]] std::span<const DefectKind> kinds_of_steps();
[[nodiscard]] std::vector<DefectKind> all_defect_kinds();

[[nodiscard]] DrawnDefect drawn_defect(const DefectKind& kind, Random& random);

/// ε is 0 below 0.5 m/s, and the inertia of both bodies is taken along the world's axes. Somebody's solver had both.
[[nodiscard]] std::vector<DrawnDefect> threshold_and_world_axes();

/// Whether `what` of the fault says the words of the defect.
[[nodiscard]] bool describes(const properties::diagnosis::Fault& fault, const DrawnDefect& defect);
/// Whether the fault describes the defect, and states its limit in `what` or `where`.
[[nodiscard]] bool names(const properties::diagnosis::Fault& fault, const DrawnDefect& defect);

// Parts of several kinds.

inline constexpr std::array laws_with_tangents{Law::reflection, Law::sticking, Law::rough, Law::coulomb};
inline constexpr std::array laws_with_friction{Law::rough, Law::coulomb};
inline constexpr std::array laws_that_stop_slip{Law::sticking, Law::rough, Law::coulomb};
inline constexpr std::array drawn_laws{Law::frictionless, Law::reflection, Law::sticking, Law::rough, Law::coulomb};

/// Changes the data of these bodies in these uses. Adds the uses to the words.
void change_data(DrawnDefect& defect, const Which& which, unsigned uses,
                 std::function<void(impulse::ContactBody<double>&, const Body&)> change);

[[nodiscard]] Vector3<double> across(const Vector3<double>& normal, const Vector3<double>& v);

}  // namespace carom::mutants
