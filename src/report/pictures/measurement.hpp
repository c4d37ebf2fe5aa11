// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <carom/collision/law.hpp>
#include <carom/collision/precision.hpp>

/// The measurements of `carom chart`, before they are drawn.
namespace carom::report {

/// The median of a distribution, the worst value among its best 99 %, and the worst value of all.
struct Quantiles {
  double median = 0;
  double of_99_percent = 0;
  double worst = 0;
};

struct Spread {
  double median = 0;
  double lowest = 0;
  double highest = 0;
};

/// The accuracy of one method on the colliding contacts of one distribution.
struct Exactness {
  std::size_t cases = 0;
  std::size_t failures = 0;        // outcomes that exceed the limit, violate an equation, or are not finite
  bool has_digits = true;          // false if the digits were not computed
  Quantiles digits;                // correct digits of the change of the velocities (forward error)
  bool has_backward_error = true;  // false for a law that determines no outcome
  Quantiles backward_error;        // ulps of the method's own precision; infinite if an outcome is not finite
  std::vector<double> digits_of_cases;
  std::vector<double> backward_errors_of_cases;
  /// Cases in which one ulp of the inputs explains an error as large as the change of the velocities. Such a backward
  /// error says nothing about the method.
  std::size_t undetermined = 0;

  /// Whether the backward errors say something about the method: some case fails, or at most half are undetermined.
  [[nodiscard]] bool shows_method() const;
};

struct FamilyMeasurement {
  std::string family;
  Exactness exactness;
  Spread nanoseconds;  // for each contact
};

struct MethodMeasurement {
  std::string name;
  std::string summary;
  Law law;
  Precision precision;
  std::vector<FamilyMeasurement> families;
  bool is_batch = false;  // many contacts at once

  /// Whether the method fails on any case of any family.
  [[nodiscard]] bool fails() const;
  /// The accuracy over the cases of all families.
  [[nodiscard]] Exactness over_all_families() const;
  /// The times of the median family, the quickest family and the slowest family.
  [[nodiscard]] Spread nanoseconds_over_all_families() const;
};

/// One method along one sweep.
struct SweepLine {
  std::string method;
  Law law;
  Precision precision;
  std::vector<double> quantity;
  std::vector<Exactness> exactness;  // at each value of `quantity`

  /// The first value of the quantity, from the easy end, at which a case fails; none if no case fails.
  [[nodiscard]] std::optional<double> leaves_limit_at() const;
};

struct SweepMeasurement {
  std::string name;
  std::string label;
  std::string summary;
  std::vector<SweepLine> lines;
};

/// Collects results case by case into an Exactness.
class ExactnessBuilder {
 public:
  /// If the outcome is not finite, `backward_error` is infinite and `digits` is 0.
  void add(double backward_error, double digits, bool within_limit);
  /// For a law without a backward error. The second overload adds a case without digits.
  void add(double digits, bool holds);
  void add(bool holds);
  ExactnessBuilder& operator+=(const ExactnessBuilder& other);
  [[nodiscard]] Exactness built() const;

 private:
  std::vector<double> backward_errors_;
  std::vector<double> digits_;
  std::size_t cases_ = 0;
  std::size_t failures_ = 0;
  std::size_t undetermined_ = 0;
};

/// The laws whose methods are charted: the laws that determine one exact outcome, and `coulomb`. The digits of
/// `coulomb` are those of its nearest answer.
[[nodiscard]] std::span<const Law> charted_laws();

/// The value of rank ⌈share · n⌉ among n sorted values (nearest rank). Precondition: `sorted` is not empty.
[[nodiscard]] double quantile(const std::vector<double>& sorted, double share);

/// A time with three significant digits, or with all digits before the point. A time of at least 1e-4 has no exponent.
[[nodiscard]] std::string in_three_digits(double number);

}  // namespace carom::report
