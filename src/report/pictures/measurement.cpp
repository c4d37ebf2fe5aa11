// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>
#include <functional>

#include <fmt/format.h>

#include <carom/collision/expects.hpp>
#include <carom/report/pictures/measurement.hpp>

namespace carom::report {
namespace {

/// The quantiles of values that should be small.
Quantiles quantiles_of(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return {quantile(values, 0.5), quantile(values, 0.99), values.back()};
}

/// The quantiles of values that should be large.
Quantiles quantiles_where_large_is_good(std::vector<double> values) {
  std::sort(values.begin(), values.end(), std::greater<>());
  return {quantile(values, 0.5), quantile(values, 0.99), values.back()};
}

}  // namespace

std::span<const Law> charted_laws() {
  static const std::vector<Law> laws = [] {
    std::vector<Law> all(laws_with_truth.begin(), laws_with_truth.end());
    all.push_back(Law::coulomb);
    return all;
  }();
  return laws;
}

double quantile(const std::vector<double>& sorted, double share) {
  CAROM_EXPECTS(!sorted.empty());
  const double rank = std::ceil(share * static_cast<double>(sorted.size()));
  const auto index = static_cast<std::size_t>(std::max(1.0, rank)) - 1;
  return sorted[std::min(index, sorted.size() - 1)];
}

std::string in_three_digits(double number) {
  return number >= 100 ? fmt::format("{:.0f}", number) : fmt::format("{:.3g}", number);
}

void ExactnessBuilder::add(double backward_error, double digits, bool within_limit) {
  backward_errors_.push_back(backward_error);
  // The relative error is 10^−digits. One ulp explains this error divided by the number of ulps.
  undetermined_ += backward_error > 0 && digits <= -std::log10(backward_error) ? 1 : 0;
  add(digits, within_limit);
}

void ExactnessBuilder::add(double digits, bool holds) {
  digits_.push_back(digits);
  add(holds);
}

void ExactnessBuilder::add(bool holds) {
  ++cases_;
  failures_ += holds ? 0 : 1;
}

ExactnessBuilder& ExactnessBuilder::operator+=(const ExactnessBuilder& other) {
  backward_errors_.insert(backward_errors_.end(), other.backward_errors_.begin(), other.backward_errors_.end());
  digits_.insert(digits_.end(), other.digits_.begin(), other.digits_.end());
  cases_ += other.cases_;
  failures_ += other.failures_;
  undetermined_ += other.undetermined_;
  return *this;
}

Exactness ExactnessBuilder::built() const {
  Exactness exactness;
  exactness.cases = cases_;
  exactness.has_digits = digits_.size() == cases_;
  exactness.failures = failures_;
  exactness.undetermined = undetermined_;
  if (!digits_.empty()) {
    exactness.digits = quantiles_where_large_is_good(digits_);
    if (!backward_errors_.empty()) {
      exactness.backward_error = quantiles_of(backward_errors_);
    }
    exactness.digits_of_cases = digits_;
    exactness.backward_errors_of_cases = backward_errors_;
  }
  return exactness;
}

bool Exactness::shows_method() const { return cases > 0 && (failures > 0 || 2 * undetermined <= cases); }

bool MethodMeasurement::fails() const {
  return std::any_of(families.begin(), families.end(),
                     [](const FamilyMeasurement& family) { return family.exactness.failures > 0; });
}

Exactness MethodMeasurement::over_all_families() const {
  Exactness all;
  for (const FamilyMeasurement& family : families) {
    const Exactness& one = family.exactness;
    all.cases += one.cases;
    all.failures += one.failures;
    all.has_backward_error = all.has_backward_error && one.has_backward_error;
    all.digits_of_cases.insert(all.digits_of_cases.end(), one.digits_of_cases.begin(), one.digits_of_cases.end());
    all.backward_errors_of_cases.insert(all.backward_errors_of_cases.end(), one.backward_errors_of_cases.begin(),
                                        one.backward_errors_of_cases.end());
    all.undetermined += one.undetermined;
  }
  if (!all.digits_of_cases.empty()) {
    all.digits = quantiles_where_large_is_good(all.digits_of_cases);
  }
  if (!all.backward_errors_of_cases.empty()) {
    all.backward_error = quantiles_of(all.backward_errors_of_cases);
  }
  return all;
}

Spread MethodMeasurement::nanoseconds_over_all_families() const {
  std::vector<double> medians;
  for (const FamilyMeasurement& family : families) {
    medians.push_back(family.nanoseconds.median);
  }
  if (medians.empty()) {
    return {};
  }
  std::sort(medians.begin(), medians.end());
  return {quantile(medians, 0.5), medians.front(), medians.back()};
}

std::optional<double> SweepLine::leaves_limit_at() const {
  for (std::size_t i = 0; i < quantity.size(); ++i) {
    if (exactness[i].failures > 0) {
      return quantity[i];
    }
  }
  return std::nullopt;
}

}  // namespace carom::report
