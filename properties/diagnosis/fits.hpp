// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <carom/properties/diagnosis/hypothesis.hpp>

namespace carom::properties::diagnosis {

/// A number that a solver may have wrong, and that an answer shows: a factor of a quantity, a number that is added to
/// it, or a limit of it.
struct Fit {
  std::string as_if;  // `{}` stands for the number
  std::string look_at;
  std::function<bool(Steps&, const KnownCase&, double number)> change;  // returns false if it does not apply
  bool changes_application = true;
  bool is_limit = false;
  double nothing = 1;                                        // the number that changes nothing
  std::span<const double> starts = {};                       // where the search for the number begins, in `unit`
  double (*unit)(const KnownCase&) = nullptr;                // nullptr: 1
  std::vector<double> (*shown)(const KnownCase&) = nullptr;  // numbers that the answer shows, in place of a search
};
[[nodiscard]] std::span<const Fit> all_fits();

/// A fitted number is a fault only if so many cases show it.
inline constexpr std::size_t least_alike = 10;

/// The numbers with which the steps may give the subject's answer. Empty if the answer shows none.
[[nodiscard]] std::vector<double> fitted(const Fit& fit, const Steps& steps, const KnownCase& one);

/// Whether two fitted numbers are equal within a thousandth.
[[nodiscard]] bool agree(double x, double y);

/// The hypothesis that a solver has this number wrong.
[[nodiscard]] Hypothesis with_number(const Fit& fit, double number);

}  // namespace carom::properties::diagnosis
