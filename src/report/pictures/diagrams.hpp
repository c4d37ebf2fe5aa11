// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <vector>

#include <carom/report/pictures/measurement.hpp>
#include <carom/report/pictures/plot.hpp>

/// The pictures of `carom chart`. The number of a method is its place in the list of its law, in all pictures.
namespace carom::report {

/// The measurements of the methods of one law, in the order of their numbers.
[[nodiscard]] std::vector<MethodMeasurement> of_law(std::span<const MethodMeasurement> methods, Law law);

/// Time against correct digits, over all families: a mark for each method, a bar down to its worst case, and the Pareto
/// line.
[[nodiscard]] Plot work_precision(std::span<const MethodMeasurement> of_one_law);

/// Time against correct digits, in one small diagram for each family.
[[nodiscard]] Plot work_precision_of_families(std::span<const MethodMeasurement> of_one_law);

/// The worst backward error along a sweep (cases with one quantity set to 10^k), with one line for each method of the
/// law.
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

/// The sound methods that no other sound method beats in both time and digits, the quickest first. A method is an index
/// below `count`.
template <class Nanoseconds, class Digits, class IsSound>
[[nodiscard]] std::vector<std::size_t> pareto(std::size_t count, const Nanoseconds& nanoseconds, const Digits& digits,
                                              const IsSound& is_sound) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < count; ++i) {
    if (is_sound(i)) {
      order.push_back(i);
    }
  }
  std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
    return nanoseconds(i) != nanoseconds(j) ? nanoseconds(i) < nanoseconds(j) : digits(i) > digits(j);
  });
  std::vector<std::size_t> line;
  for (const std::size_t i : order) {
    if (line.empty() || digits(i) > digits(line.back())) {
      line.push_back(i);
    }
  }
  return line;
}

}  // namespace carom::report
