// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <carom/collision/subject.hpp>
#include <carom/oracles/judge/coulomb_answers.hpp>
#include <carom/oracles/judge/yardstick.hpp>
#include <carom/properties/gate/trial.hpp>

namespace carom::properties::plan {

/// The axes in which a solver keeps J⁻¹.
enum class Frame { body, world };

/// A built-in method that a plan may choose.
struct Candidate {
  Subject subject;      // its `law` is the law that the method computes
  std::string scalar;   // "float", "double", "long double", "double-double"
  int scalar_rank = 0;  // smaller for fewer bits
  std::string solve;    // "scalar", or the method for the 3×3 system
  int solve_rank = 0;   // 0 for the recommended method
  Frame frame = Frame::body;
  bool is_batch = false;  // solves many contacts at once
};

/// Whether a plan prefers x to y if their times do not decide: by a cheaper law, then by precision, solve, frame and
/// name. The body frame comes first, because it is safer.
[[nodiscard]] bool is_less(const Candidate& x, const Candidate& y);

[[nodiscard]] bool differ_in_precision_alone(const Candidate& x, const Candidate& y);

/// The law and the accuracy that a user asks for.
struct Demand {
  Law law = Law::rough;                             // not `any`
  double limit_ulps = oracles::default_limit_ulps;  // of binary64, for every precision of a candidate
  /// Replaces the limit in ulps. At every colliding contact, the velocity change must have this many correct digits
  /// (Accuracy::digits). At other contacts, the velocities must stay the same to this many digits.
  std::optional<int> digits = {};
  bool exact_law = false;  // accept a cheaper law only if it gives exactly the same outcomes
};

struct Result {
  std::string failure;                   // why the candidate does not serve; empty if it does
  std::optional<double> backward_error;  // ulps of binary64; for laws that determine an outcome
  std::optional<double> digits;          // of the velocity change, if the contact collides
};

struct WorstFailure {
  std::size_t contact;  // number of the contact
  Result result;
};

struct Certificate {
  std::size_t contacts = 0;
  std::size_t failures = 0;
  std::optional<double> worst_backward_error;
  std::optional<double> least_digits;
  std::optional<WorstFailure> worst;  // by backward error, then by digits; the first of equals

  [[nodiscard]] bool serves() const { return failures == 0; }
  void add(std::size_t contact, const Result& result);
  Certificate& operator+=(const Certificate& other);
};

/// Judges candidates on one contact. Keeps a reference to the demand. For one thread. Preconditions: the collision is
/// valid; the law is not `any`.
class Certifier {
 public:
  Certifier(const Collision& collision, const Demand& demand);

  [[nodiscard]] const oracles::ExactCase& exact() const { return judged_.exact(); }
  [[nodiscard]] bool collides() const { return exact().state() == oracles::ContactState::colliding; }

  /// Judges an answer by the exact truth, and by every claimed invariant of one outcome.
  [[nodiscard]] Result judge(const Candidate& candidate, const Answer& answer) const;

 private:
  [[nodiscard]] std::string violated_invariant(const Answer& answer) const;
  [[nodiscard]] bool has_digits(const oracles::LiftedOutcome& outcome, const Result& result) const;
  [[nodiscard]] const std::vector<oracles::CoulombAnswer>& answers_of_coulomb() const;

  const Demand& demand_;
  JudgedCase judged_;
  oracles::Yardstick ulps_;  // of binary64
  Claim claim_;              // of the law and the accuracy asked for
  mutable std::optional<std::vector<oracles::CoulombAnswer>> answers_;
};

}  // namespace carom::properties::plan
