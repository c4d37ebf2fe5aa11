// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <vector>

#include <carom/report/chart/measurement.hpp>
#include <carom/report/drawing/plot.hpp>

/// The pictures of `carom chart`. In all of them a method has the same number, its place in the list of its model.
namespace carom::report {

/// The measurements of the methods of one model, in the order of their numbers.
[[nodiscard]] std::vector<MethodMeasurement> of_model(std::span<const MethodMeasurement> methods, Model model);

/// Time against correct digits, over all families: one mark a method, a bar down to its worst case, the Pareto line.
[[nodiscard]] Plot work_precision(std::span<const MethodMeasurement> of_one_model);

/// The same, one small diagram for each family.
[[nodiscard]] Plot work_precision_of_families(std::span<const MethodMeasurement> of_one_model);

/// The worst backward error along a sweep, one line a method of the model.
[[nodiscard]] Plot stability_map(const SweepMeasurement& sweep, Model model, double limit_ulps);

/// The share of cases that can be solved to so many digits within a time, by the best method for it.
[[nodiscard]] Plot deadline(std::span<const MethodMeasurement> of_one_model);

/// One step of a deadline curve: from so many nanoseconds on, this share of the cases, by this method.
struct DeadlineStep {
  double nanoseconds;
  double share;
  std::string method;
};

/// The digits that the deadline diagram asks for.
inline constexpr std::array deadline_digits{3, 6, 9, 12, 15, 18};

[[nodiscard]] std::vector<DeadlineStep> deadline_steps(std::span<const MethodMeasurement> of_one_model, double digits);

/// The methods that none beats both in time and in digits, quickest first: of those that fail nowhere.
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
