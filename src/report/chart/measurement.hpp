// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

/// What `carom chart` measures, before it is drawn.
namespace carom::report {

/// Of the cases of a distribution; of 99 in 100 and of all of them, the worse end.
struct Quantiles {
  double median = 0;
  double of_99_percent = 0;
  double worst = 0;
};

/// Of repeated measurements.
struct Spread {
  double median = 0;
  double lowest = 0;
  double highest = 0;
};

/// How exact one method is on the colliding contacts of one distribution.
struct Exactness {
  std::size_t cases = 0;
  std::size_t failures = 0;        // beyond the limit on the backward error, or violating an equation, or not finite
  bool has_digits = true;          // false where they were not asked for
  Quantiles digits;                // correct ones, of the change of the velocities (forward error)
  bool has_backward_error = true;  // false of a law that determines no outcome
  Quantiles backward_error;        // ulps of the method's own precision; infinite where an outcome is not finite
  std::vector<double> digits_of_cases;
};

struct FamilyMeasurement {
  std::string family;
  Exactness exactness;
  Spread nanoseconds;  // for each contact
};

struct MethodMeasurement {
  std::string name;
  std::string summary;
  Model model;
  Precision precision;
  std::vector<FamilyMeasurement> families;

  /// Whether it fails on any case of any family.
  [[nodiscard]] bool fails() const;
  /// Over the cases of all families; of the backward error the worst alone.
  [[nodiscard]] Exactness over_all_families() const;
  /// The median family, the quickest and the slowest.
  [[nodiscard]] Spread nanoseconds_over_all_families() const;
};

/// One method along one sweep.
struct SweepLine {
  std::string method;
  Model model;
  Precision precision;
  std::vector<double> quantity;
  std::vector<Exactness> exactness;  // at each quantity

  /// The first quantity, from the easy end, at which a case is beyond the limit; none where there is none.
  [[nodiscard]] std::optional<double> leaves_limit_at() const;
};

struct SweepMeasurement {
  std::string name;
  std::string label;
  std::string summary;
  std::vector<SweepLine> lines;
};

/// The exactness of results that were collected case by case.
class ExactnessBuilder {
 public:
  /// `backward_error` is infinite and `digits` 0 where the outcome is not finite.
  void add(double backward_error, double digits, bool within_limit);
  /// Of a law that has no backward error; where the digits were not asked for, whether it holds alone.
  void add(double digits, bool holds);
  void add(bool holds);
  ExactnessBuilder& operator+=(const ExactnessBuilder& other);
  [[nodiscard]] Exactness built() const;

 private:
  std::vector<double> backward_errors_;
  std::vector<double> digits_;
  std::size_t cases_ = 0;
  std::size_t failures_ = 0;
};

/// The laws whose methods are charted: those with a truth, and `coulomb`, of whose answers the nearest gives the
/// digits.
[[nodiscard]] std::span<const Model> charted_models();

/// The value below which so large a share of the sorted values lies (nearest rank). Precondition: not empty.
[[nodiscard]] double quantile(const std::vector<double>& sorted, double share);

/// A time to three digits or all before the point, without an exponent.
[[nodiscard]] std::string in_three_digits(double number);

}  // namespace carom::report
