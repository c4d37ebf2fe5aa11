// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <carom/oracles/judge/coulomb_case.hpp>
#include <carom/oracles/judge/yardstick.hpp>
#include <carom/properties/plan/candidate.hpp>
#include <carom/properties/trial/trial.hpp>

namespace carom::properties::plan {

/// What the user asks for.
struct Demand {
  Model law = Model::rough;                         // not `any`
  double limit_ulps = oracles::default_limit_ulps;  // of binary64, whatever a candidate computes in
  /// In place of ulps: so many correct digits of the change of the velocities of every contact that collides, by
  /// Accuracy::digits; elsewhere the velocities are kept to that.
  std::optional<int> digits = {};
  bool exact_law = false;  // a lesser law only where it is, exactly, the one asked for
};

/// What came of one candidate on one contact.
struct Result {
  std::string failure;                   // why it does not serve; empty where it does
  std::optional<double> backward_error;  // ulps of binary64; of laws that determine an outcome
  std::optional<double> digits;          // of the change of the velocities, where the contact collides
};

/// The worst contact of those that a candidate does not serve.
struct WorstFailure {
  std::size_t contact;  // its number
  Result result;
};

/// What is certified of a candidate on a set of contacts.
struct Certificate {
  std::size_t contacts = 0;
  std::size_t failures = 0;
  std::optional<double> worst_backward_error;
  std::optional<double> least_digits;
  std::optional<WorstFailure> worst;  // by its backward error, then its digits, then the first

  [[nodiscard]] bool serves() const { return failures == 0; }
  void add(std::size_t contact, const Result& result);
  Certificate& operator+=(const Certificate& other);
};

/// A contact, what is exactly known of it, and what an outcome is held against: the law and the accuracy asked for.
/// For one thread. Preconditions: the collision is valid; the law is not `any`.
class Certifier {
 public:
  Certifier(const Collision& collision, const Demand& demand);

  [[nodiscard]] const oracles::ExactCase& exact() const { return judged_.exact(); }
  [[nodiscard]] bool collides() const { return exact().approach() == oracles::Approach::colliding; }

  /// Judges a candidate's answer against the law that was asked for, by exact truth and by every invariant of one
  /// outcome that is claimed for that law.
  [[nodiscard]] Result judge(const Candidate& candidate, const Answer& answer) const;

 private:
  [[nodiscard]] std::string violated_invariant(const Answer& answer) const;
  [[nodiscard]] bool has_digits(const oracles::LiftedOutcome& outcome, const Result& result) const;
  [[nodiscard]] const std::vector<oracles::CoulombAnswer>& answers_of_coulomb() const;

  const Demand& demand_;
  JudgedCase judged_;
  oracles::Yardstick ulps_;  // of binary64
  Claim claim_;              // by what was asked for
  mutable std::optional<std::vector<oracles::CoulombAnswer>> answers_;
};

}  // namespace carom::properties::plan
