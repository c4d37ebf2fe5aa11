// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include <carom/report/pictures/measurement.hpp>
#include <carom/report/pictures/plot.hpp>

/// The pictures of `carom chart`.
namespace carom::report {

/// The measurements of the methods of one law.
[[nodiscard]] std::vector<MethodMeasurement> of_law(std::span<const MethodMeasurement> methods, Law law);

/// The methods that `work_precision` draws, the quickest first, at most twelve. Two methods look the same if their
/// times are within 10 % and their errors within a factor of 3; the earlier in the list is drawn. A method is left out
/// if a quicker one has no larger errors, up to that factor. Methods of batches are compared only with each other.
[[nodiscard]] std::vector<MethodMeasurement> methods_to_draw(std::span<const MethodMeasurement> of_one_law);

/// Time against backward error, over all families: a mark for the worst case of each of `methods_to_draw`, and a line
/// down to its median case. Precondition: the law determines the outcome.
[[nodiscard]] Plot work_precision(std::span<const MethodMeasurement> of_one_law, double limit_ulps);

struct DrawnLine {
  const SweepLine* line;
  std::size_t alike;  // further lines for which it stands
};

/// The lines that `stability_map` draws, at most eight. One method of each precision stands for those that stay within
/// the limit: it has the largest error. Other lines of one precision look the same if their errors are within a factor
/// of 3 everywhere; the earliest is drawn.
[[nodiscard]] std::vector<DrawnLine> lines_to_draw(const SweepMeasurement& sweep, Law law);

/// The worst backward error along a sweep (cases with one quantity set to 10^k), with a line for each of
/// `lines_to_draw`. A line has gaps where the errors show nothing (Exactness::shows_method).
[[nodiscard]] Plot stability_map(const SweepMeasurement& sweep, Law law, double limit_ulps);

/// For each time t and each d of deadline_digits: the largest share of cases that one method solves to d digits within
/// t.
[[nodiscard]] Plot deadline(std::span<const MethodMeasurement> of_one_law);

/// One step of a deadline curve: given at least this time, the method solves this share of the cases.
struct DeadlineStep {
  double nanoseconds;
  double share;
  std::string method;
};

/// The numbers of digits in the deadline diagram.
inline constexpr std::array deadline_digits{3, 6, 9, 12, 15, 18};

[[nodiscard]] std::vector<DeadlineStep> deadline_steps(std::span<const MethodMeasurement> of_one_law, double digits);

}  // namespace carom::report
