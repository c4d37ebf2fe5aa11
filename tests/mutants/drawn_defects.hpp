// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <array>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <random>
#include <span>
#include <string>
#include <string_view>
#include <vector>

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
  [[nodiscard]] double share();  // in [0, 1)

  std::mt19937_64 engine_;
};

inline constexpr std::array drawn_laws{Law::frictionless, Law::reflection, Law::sticking, Law::rough, Law::coulomb};

/// A way in which a defect can be. In its texts, `{bodies}` and `{part}` stand for the bodies of the place, and `{use}`
/// for the use. `{c}` and `{limit}` stand for the number; a description states a limit. `{how}` stands for the words of
/// a wrong factor of this size, and `{axis}` for the axis.
struct Way {
  std::string_view words;
  std::string_view named_by;  // DrawnDefect::named_by; each alternative also has the `{bodies}` of the words
  Change change;
  const char* (*also_named_by)(const Drawn&) = nullptr;  // other alternatives
};

inline constexpr std::array laws_with_friction{Law::rough, Law::coulomb};

struct DefectKind {
  struct Draw {
    std::string_view name;
    Drawn (*draw)(Random&);
    std::span<const Law> laws = drawn_laws;  // that have the defect
  } by;
  std::vector<Way> ways;
};

/// A defect with drawn parameters, and what a description has to say to name it.
struct DrawnDefect {
  std::string_view kind;
  std::string words;  // "ε is multiplied by 0.437"
  /// Alternatives, separated by ` | `. Of one of them, a description contains every part, and parts are separated by
  /// ` & `. A part `!x` means that x is absent. `A` and `B` mean this body or both. `%x` means any word of a group
  /// (drawn_defects.cpp).
  std::string named_by;
  std::optional<double> limit;  // a description states it within a quarter
  DrawnChange change;
};

/// Data and geometry that a solver reads or uses wrongly.
[[nodiscard]] std::span<const DefectKind> kinds_of_data();
/// Velocities, impulses, friction and limits that are wrong.
[[nodiscard]] std::span<const DefectKind> kinds_of_steps();

/// Draws one body or both, and then one of the uses.
[[nodiscard]] Place drawn_bodies(Random& random, Use use = everywhere);
[[nodiscard]] Place drawn_place(Random& random,
                                std::initializer_list<Use> uses = {everywhere, in_matrix, in_application});

/// A defect of a solver of this law.
[[nodiscard]] DrawnDefect drawn_defect(Law law, Random& random);

/// ε is 0 below 0.5 m/s, and the inertia of both bodies is taken along the world's axes. Somebody's solver had both.
[[nodiscard]] std::vector<DrawnDefect> threshold_and_world_axes();

/// Whether `what` of the fault says the words of the defect.
[[nodiscard]] bool describes(const properties::diagnosis::Fault& fault, const DrawnDefect& defect);
/// Whether the fault describes the defect, and states its limit in `what` or `where`.
[[nodiscard]] bool names(const properties::diagnosis::Fault& fault, const DrawnDefect& defect);

}  // namespace carom::mutants
