// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include <carom/collision/collision.hpp>
#include <carom/collision/subject.hpp>
#include <carom/properties/cases/family.hpp>
#include <carom/properties/cases/sweep.hpp>
#include <carom/properties/gate/answers.hpp>
#include <carom/properties/gate/workers.hpp>
#include <carom/report/pictures/measurement.hpp>
#include <carom/subjects/methods.hpp>

/// The measurements of the command `chart`.
namespace carom::tool::chart {

/// Subjects, each with an open session. A program is started again after a failure. After a hundred failures, or after
/// failures that took a minute, its answers are Skipped.
class ChartedSubjects {
 public:
  explicit ChartedSubjects(std::vector<Subject> subjects, std::stop_token stop = {});
  ChartedSubjects(const ChartedSubjects&) = delete;
  ChartedSubjects& operator=(const ChartedSubjects&) = delete;

  [[nodiscard]] std::span<const Subject> subjects() const { return subjects_; }

  /// Why a subject gave no further answers, with its name. Empty if none stopped.
  [[nodiscard]] const std::string& failure() const { return failure_; }

  /// The answers of each subject to the collisions, in the order of the subjects.
  [[nodiscard]] std::vector<std::vector<Answer>> answers_to(std::span<const Collision> collisions);

  /// Ends the sessions that are not over. Throws if a subject does not end as it should.
  void close();

 private:
  std::vector<Subject> subjects_;
  std::deque<properties::Restarts> restarts_;  // the sessions refer to the elements
  std::vector<Session> sessions_;
  std::vector<bool> are_over_;
  std::string failure_;
};

/// The number of contacts that are timed together. They fit into the first-level cache.
inline constexpr std::size_t contacts_in_kernel = 64;

/// The input of one timed kernel: a method, and the collisions of one family.
struct TimedKernel {
  const subjects::Method* method;
  std::span<const Collision> collisions;  // not empty
};

/// The time of each kernel [ns for each contact], measured by Google Benchmark. The repetitions run in random order, so
/// that a disturbance of the machine affects all kernels. Calls `progress(done, all)` if it is set.
[[nodiscard]] std::vector<report::Spread> measured_times(
    std::span<const TimedKernel> kernels, int repetitions,
    const std::function<void(std::uint64_t, std::uint64_t)>& progress);

/// The first `count` colliding collisions of a family. There are fewer if less than one case in 20 collides.
[[nodiscard]] std::vector<Collision> colliding_cases(const properties::Family& family, std::uint64_t seed,
                                                     std::size_t count);

/// The first `count` colliding collisions of a sweep whose quantity has this value. There are fewer if less than one
/// case in 20 collides.
[[nodiscard]] std::vector<Collision> colliding_cases(const properties::Sweep& sweep, double quantity,
                                                     std::uint64_t seed, std::size_t count);

/// Whether to compute all answers of the law `coulomb`, which takes some milliseconds a case. Without them, the law's
/// equations still judge an outcome, but the number of its correct digits is unknown.
enum class AnswersOfCoulomb { found, left_out };

/// The accuracy of each subject on these colliding collisions, in the order of the subjects. The truth (the exact
/// outcome) judges an outcome, after the effects that the subject declares are taken out. Under `coulomb`, which may
/// have several answers, the law's equations judge the outcome, and the nearest answer gives its digits. A case is left
/// out if the subject's precision cannot represent it, if the law demands nothing of its outcome, or if it does not
/// collide because of a declared effect. Precondition: each subject has a law.
[[nodiscard]] std::vector<report::Exactness> measured_exactness(ChartedSubjects& charted,
                                                                std::span<const Collision> collisions,
                                                                double limit_ulps, const properties::Workers& workers,
                                                                AnswersOfCoulomb answers_of_coulomb);

}  // namespace carom::tool::chart
